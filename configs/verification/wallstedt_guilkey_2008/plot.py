#!/usr/bin/python3
"""Draws figures 2 and 5 of Wallstedt & Guilkey (2008): particles with their domains at three times, on a grid of 8 x 8 cells.

usage: plot.py FOLDER [--matpoint PROGRAM]     (needs Debian's python3-matplotlib)
"""

import argparse
import csv
import json
import pathlib
import subprocess

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.ticker import MultipleLocator

HERE = pathlib.Path(__file__).resolve().parent
CELL, A, PERIOD = 1 / 8, 0.1, 0.02  # m, m, s
HALF_SIZE = CELL / 4  # of a domain at the start: 2 x 2 particles a cell


def particles(program, folder, scene, every, count):
    """The tables of particles at times 0, every, ..., a column of numbers by name."""
    outputs = [{"type": "csv", "every": every, "fields": ["displacement", "deformation_gradient"]}]
    settings = {"/outputs": outputs, "/time/end": every * (count - 1), "/grid/cell_size": CELL}
    command = [program, "run", HERE / f"{scene}.json", "--output", folder, "--quiet", "--threads", "1"]
    for pointer, value in settings.items():
        command += ["--set", f"{pointer}={json.dumps(value)}"]
    subprocess.run(command, check=True)
    tables = []
    for file in sorted(folder.glob("particles_*_0*.csv"))[:count]:
        with open(file, newline="") as stream:
            rows = list(csv.DictReader(stream))
        tables.append({name: np.array([float(row[name]) for row in rows]) for name in rows[0]})
    return tables


def domains(table):
    """Corners of the boxes x +- l0 diag(F), eq. 63."""
    center = np.stack([table["x"], table["y"]], axis=1)
    half = HALF_SIZE * np.stack([table["deformation_gradient_xx"], table["deformation_gradient_yy"]], axis=1)
    corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    return center[:, None, :] + corners * half[:, None, :]


def draw(tables, every):
    figure, panels = plt.subplots(1, len(tables), figsize=(9.6, 3.3), sharey=True, layout="constrained")
    for number, (panel, table) in enumerate(zip(panels, tables)):
        size = np.hypot(table["displacement_x"], table["displacement_y"])
        boxes = PolyCollection(domains(table), array=size, cmap="viridis", edgecolors="white", linewidths=0.8)
        boxes.set_clim(0, A)
        panel.add_collection(boxes)
        panel.plot(table["x"], table["y"], "k.", ms=1.5)
        panel.set(title=f"t = {number * every / PERIOD:g} T", xlabel="x", aspect="equal", xlim=(0, 1), ylim=(0, 1),
                  xticks=[0, 0.5, 1], yticks=[0, 0.5, 1])
        for lines in (panel.xaxis, panel.yaxis):
            lines.set_minor_locator(MultipleLocator(CELL))
        panel.grid(which="both", lw=0.5, color="0.4")
        panel.set_axisbelow(False)
    panels[0].set_ylabel("y")
    figure.colorbar(boxes, ax=panels, label="|displacement|", shrink=0.8)
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path, help="where pictures and results go")
    parser.add_argument("--matpoint", default="matpoint", help="the program, by default the one in PATH")
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    for name, scene, every in (("figure_02", "axis_aligned", PERIOD / 8), ("figure_05", "ring", PERIOD / 4)):
        tables = particles(arguments.matpoint, arguments.folder / "runs" / name, scene, every, 3)
        draw(tables, every).savefig(arguments.folder / f"{name}.png", dpi=80)
        print(arguments.folder / f"{name}.png")


if __name__ == "__main__":
    main()
