#!/usr/bin/env python3
"""The largest memory of a run is that of the particles' fields and little more, from seeding to sorting particles that have moved.

usage: memory_test.py MATPOINT

What a particle takes is the difference of two runs that differ in their numbers of particles: the program itself takes the same in both.
"""
import random
import sys
import tempfile
from pathlib import Path

from runs import block_of, run_scene

SCENE, FEW, MANY = "block_quadratic", 49, 97
THREADS = 2
MOVING = {"/time/max_steps": 12, "/bodies/block/velocity": [15, 10, 5]}  # by two cells: particles are sorted more than once
GRID = 30  # bytes a particle: ten numbers a node, six bytes of what it is and who follows it, and blocks with nodes that no particle reaches
ROWS = 34  # of a file of points, with what was seeded of each: while particles are made from them; the grid comes later


def lattice(counts, folder):
    return {}


def box(counts, folder):
    return {"/bodies/block/geometry": {"type": "box", "min": [0.25] * 3, "max": [0.25 + counts / (counts - 1)] * 3},
            "/bodies/block/particles_per_cell": 8}


def points(counts, folder):
    number = random.Random(1)
    file = Path(folder) / "points.csv"
    with open(file, "w") as rows:
        print("x,y,z,volume", file=rows)
        for _ in range(counts**3):
            print(*(f"{number.uniform(0.25, 1.25):.9f}" for _ in range(3)), 1 / counts**3, sep=",", file=rows)
    return {"/bodies/block/geometry": {"type": "points", "file": str(file)}}


def bytes_a_particle(program, geometry):
    """Of the largest memory, and of the fields."""
    few, many = [], []
    with tempfile.TemporaryDirectory() as folder:
        for counts, figures in ((FEW, few), (MANY, many)):
            summary = run_scene(program, SCENE, block_of(counts) | geometry(counts, folder) | MOVING, THREADS)
            if summary["status"] != "completed":
                raise SystemExit(f"{geometry.__name__}: {summary['status']}")
            figures += summary["peak_memory_bytes"], summary["particles"], summary["bytes_per_particle"]
    return (many[0] - few[0]) / (many[1] - few[1]), many[2]


def main(program):
    mistakes = 0
    for geometry, allowed in ((lattice, GRID), (box, GRID), (points, ROWS)):
        largest, fields = bytes_a_particle(program, geometry)
        mistakes += largest > fields + allowed
        print(f"{geometry.__name__}: {largest:.1f} bytes a particle, {largest - fields:.1f} beside its fields; at most {allowed}")
    return 1 if mistakes else 0


sys.exit(main(sys.argv[1]))
