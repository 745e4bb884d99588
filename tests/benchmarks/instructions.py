#!/usr/bin/env python3
"""Instructions per particle and step, counted by valgrind, against the record instructions.json beside this script.

usage: instructions.py MATPOINT COMPILER [--record]    (COMPILER: "GNU 12.2.0"; --record writes the record anew)

A count is the difference of two runs that differ by ten steps. It is the same on a busy machine, and fails when it has grown by
more than 5 %. Counts of another compiler or instruction set can't be compared: then the status is 77, which CTest shows as skipped.
"""
import json
import re
import sys
import tempfile
from pathlib import Path

from runs import arguments, block_of, call

RECORD = Path(__file__).with_name("instructions.json")
SCENES = {"linear": "block_linear", "gimp": "block_gimp_contiguous", "quadratic": "block_quadratic", "cubic": "block_cubic"}
COUNTS, STEPS, FIRST = 17, 10, 2
GROWTH = 1.05


def instructions(program, scene, steps):
    with tempfile.TemporaryDirectory() as folder:
        run = arguments(scene, block_of(COUNTS) | {"/time/max_steps": steps}, 1, folder)
        said = call(["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/counts", program, *run]).stderr
        summary = json.loads((Path(folder) / "summary.json").read_text())
    return int(re.search(r"Collected : (\d+)", said)[1]), summary


def measure(program, compiler):
    counts = {}
    for name, scene in SCENES.items():
        few, _ = instructions(program, scene, FIRST)
        many, summary = instructions(program, scene, FIRST + STEPS)
        counts[name] = round((many - few) / (STEPS * summary["particles"]), 1)
    return {"compiler": compiler, "instruction_set": summary.get("instruction_set", "unknown"),
            "particles": summary["particles"], "instructions_per_particle_step": counts}


def main(program, compiler, *options):
    again = f"{sys.argv[0]} {program} {compiler!r} --record"
    if "--record" in options:
        RECORD.write_text(json.dumps(measure(program, compiler), indent=2) + "\n")
        return 0
    recorded = json.loads(RECORD.read_text())
    measured = measure(program, compiler) if recorded["compiler"] == compiler else {"compiler": compiler}
    for key, value in measured.items():
        if key != "instructions_per_particle_step" and value != recorded[key]:
            print(f"The record is of {key} {recorded[key]}, this is {value}: not comparable. To record: {again}")
            return 77
    grown = False
    for name, count in measured["instructions_per_particle_step"].items():
        before = recorded["instructions_per_particle_step"][name]
        print(f"{name}: {count} instructions per particle and step, {100 * (count / before - 1):+.1f} % of the record's {before}")
        grown |= count > GROWTH * before
    if grown:
        print(f"A step has become more expensive by over {100 * (GROWTH - 1):.0f} %. Find out which phase (tests/benchmarks/README.md). "
              f"If it buys something, say in the commit what, and record it: {again}")
    return 1 if grown else 0


sys.exit(main(*sys.argv[1:]))
