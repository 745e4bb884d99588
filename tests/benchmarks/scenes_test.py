#!/usr/bin/env python3
"""The benchmarks' scenes run, blocks made small, and agree with the textbook loop, which shares no code with the framework.

usage: scenes_test.py MATPOINT"""
import sys

from runs import SCENES, UNEVEN, block_of, run_reference, run_scene

COUNTS, STEPS = 33, 10
REFERENCE = {"block_linear": "linear", "block_gimp_uniform": "gimp", "block_quadratic": "quadratic", "block_cubic": "cubic"}
TOLERANCE = {"double": 1e-12, "single": 1e-5}  # sums are formed in another order


def differences(program, scene, precision):
    size = {} if scene in UNEVEN else block_of(COUNTS, scene)
    values = size | {"/time/max_steps": STEPS, "/space/precision": precision}
    if scene in REFERENCE:
        values |= {"/grid/light_nodes": 0}  # the textbook has none
    summary = run_scene(program, scene, values)
    if summary["status"] != "completed" or summary["steps"] != STEPS:
        yield f"{scene} {precision}: {summary['status']} after {summary['steps']} steps"
    if scene in REFERENCE:
        here = summary["final"]["kinetic_energy"]
        there = run_reference(program, REFERENCE[scene], precision, "random", COUNTS, STEPS)["kinetic_energy"]
        if not abs(here / there - 1) <= TOLERANCE[precision]:
            yield f"{scene} {precision}: kinetic energy {here!r}, by the textbook loop {there!r}"


def main(program):
    scenes = sorted(path.stem for path in SCENES.glob("*.json") if not path.name.endswith(".test.json"))
    found = [line for scene in scenes for precision in ("double", "single") for line in differences(program, scene, precision)]
    print(*found, f"{len(scenes)} scenes, {len(found)} mistakes", sep="\n")
    return 1 if found or not scenes else 0


sys.exit(main(sys.argv[1]))
