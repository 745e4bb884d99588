#!/usr/bin/env python3
"""Instructions per particle and step, counted by valgrind, against the record instructions.json beside this script.

usage: instructions.py MATPOINT COMPILER [--record]    (COMPILER: "GNU 12.2.0"; --record writes the record anew)

Fails when a count has grown by more than 5 %. Counts of another compiler or instruction set can't be compared: then the status is 77,
which CTest shows as skipped.
"""
import json
import sys
from pathlib import Path

from callgrind import instructions_per_step

RECORD = Path(__file__).with_name("instructions.json")
SCENES = {"linear": "block_linear", "gimp": "block_gimp_contiguous", "quadratic": "block_quadratic", "cubic": "block_cubic"}
GROWTH = 1.05


def measure(program, compiler):
    counts = {}
    for name, scene in SCENES.items():
        count, summary = instructions_per_step(program, scene)
        counts[name] = round(count, 1)
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
