"""Counts the instructions of a step, which are the same on a busy machine."""
import json
import re
import tempfile
from pathlib import Path

from runs import arguments, block_of, call

COUNTS, STEPS, FIRST = 17, 10, 2


def run_counted(program, scene, values, steps):
    with tempfile.TemporaryDirectory() as folder:
        run = arguments(scene, block_of(COUNTS) | {"/time/max_steps": steps} | values, 1, folder)
        said = call(["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/counts", program, *run]).stderr
        return int(re.search(r"Collected : (\d+)", said)[1]), json.loads((Path(folder) / "summary.json").read_text())


def instructions_per_step(program, scene, values={}):
    """Instructions per particle and step, of a small block, and summary.json. They are the difference of two runs that differ by ten
    steps, so that the start does not count."""
    few, _ = run_counted(program, scene, values, FIRST)
    many, summary = run_counted(program, scene, values, FIRST + STEPS)
    return (many - few) / (STEPS * summary["particles"]), summary


def counted_instruction_set(program):
    """What valgrind runs, which does not know the newest."""
    return call(["valgrind", "--tool=none", program, "--version"]).stdout.partition("(")[2].partition(")")[0]
