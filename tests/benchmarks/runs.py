"""Runs the program and the textbook loop, and reads what they measured."""
import json
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SCENES = ROOT / "configs/benchmarks"
PROGRAM = ROOT / "build/release/bin/matpoint"
# Scenes that are hard to share among threads, and how many times faster two should be; 1: not slower.
UNEVEN = {"small_quadratic": 1, "sheet_quadratic": 1.8, "cloud_quadratic": 1.8, "corner_quadratic": 1.8}


def call(command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"status {done.returncode}: {' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done


def block_of(counts, scene="block"):
    """The values that make a scene one of `counts` particles along an edge, two a cell; counts - 1 is a multiple of 8.
    The block is half a cell longer than 1 m (configs/benchmarks/README.md)."""
    axes = {"square_quadratic": 2, "bar_quadratic": 1}.get(scene, 3)
    return {"/bodies/block/geometry/counts": counts, "/bodies/block/geometry/max": [0.25 + counts / (counts - 1)] * axes,
            "/grid/cell_size": 2 / (counts - 1)}


def arguments(scene, values, threads, folder):
    sets = [word for pointer, value in values.items()
            for word in ("--set", f"{pointer}={value if isinstance(value, str) else json.dumps(value)}")]
    return ["run", SCENES / f"{scene}.json", "--quiet", "--threads", threads, "--output", folder, *sets]


def run_scene(program, scene, values={}, threads=1):
    """summary.json of a scene of configs/benchmarks."""
    with tempfile.TemporaryDirectory() as folder:
        call([program, *arguments(scene, values, threads, folder)])
        return json.loads((Path(folder) / "summary.json").read_text())


def instruction_set(program):
    """What the program's loops are compiled for on this machine: "matpoint 0.1.0 (x86-64-v3)"."""
    return call([program, "--version"]).stdout.partition("(")[2].partition(")")[0]


def run_reference(program, shape, precision, order, counts, steps):
    """What tests/benchmarks/reference_loop.cpp prints; it lies beside the program, for each instruction set."""
    loop = Path(program).parent / f"reference_loop.{instruction_set(program)}"
    return json.loads(call([loop, shape, precision, order, counts, steps]).stdout)
