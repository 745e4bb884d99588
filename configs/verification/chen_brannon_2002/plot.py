#!/usr/bin/python3
"""Runs the scenes of this folder and draws figures 2, 5, 8 to 10, 14 and 18 of Chen & Brannon (2002) with exact solutions.

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

HERE = pathlib.Path(__file__).resolve().parent
C = 100.0  # wave speed
PATHS = {"x_0005": 0.005, "x_0255": 0.255, "x_0495": 0.495, "x_0505": 0.505, "x_0745": 0.745, "x_0995": 0.995}


class Runner:
    def __init__(self, program, folder):
        self.program = program
        self.folder = folder

    def run(self, scene, name, **assignments):
        """Runs a scene with values replaced (keys are JSON pointers with __ for /); returns the folder of results."""
        output = self.folder / "runs" / name
        command = [self.program, "run", HERE / f"{scene}.json", "--output", output, "--quiet", "--threads", "1"]
        for key, value in assignments.items():
            command += ["--set", f"/{key.replace('__', '/')}={json.dumps(value)}"]
        subprocess.run(command, check=True)
        return output

    def profile(self, scene, name, body, time, **assignments):
        """Positions and stresses of a body's particles at a time."""
        outputs = [{"type": "csv", "every": time, "fields": ["stress"]}]
        folder = self.run(scene, name, time__end=time, outputs=outputs, **assignments)
        table = columns(folder / f"particles_{body}_000001.csv")
        return table["x"], table["stress_xx"]


def columns(file):
    with open(file, newline="") as stream:
        rows = list(csv.DictReader(stream))
    return {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}


def fixed_bar(x, t):
    """Stress of the bar that is fixed on the left, up to t = 3L/c."""
    return (C * t > 1 - x) * 1.0 + (C * t > 1 + x) * 1.0 - (C * t > 3 - x) * 1.0


def path(x, t):
    """Displacement of the bar that is drawn at both ends; the integral of a square wave of period 2L/c."""

    def ramp(s):
        s = np.maximum(s, 0)
        return (s + np.arccos(np.cos(np.pi * s)) / np.pi) / 2

    return 1e-4 * (ramp(C * t - 1 + x) - ramp(C * t - x))


def figure_2(runner):
    figure, panels = plt.subplots(1, 3, figsize=(9.6, 2.9), sharey=True, layout="constrained")
    for panel, time in zip(panels, (0.005, 0.015, 0.025)):
        for number, style in ((10, "o-"), (100, "-"), (500, "-")):
            x, stress = runner.profile("figure_02_fixed_bar", f"02_{number}_{time}", "bar", time,
                                       grid__cell_size=1 / number)
            panel.plot(x, stress, style, ms=3, lw=0.9, label=f"{number} particles")
        x = np.linspace(0, 1, 2001)
        panel.plot(x, fixed_bar(x, time), "k--", lw=0.8, label="exact")
        panel.set(title=f"t = {time * C:g} L/c", xlabel="x")
    panels[0].set_ylabel("stress / f")
    panels[0].legend(frameon=False, fontsize=8)
    return figure


def figure_5(runner):
    folder = runner.run("figure_03_both_ends", "05")
    figure, panel = plt.subplots(figsize=(6.4, 3.4), layout="constrained")
    for number, (probe, x) in enumerate(PATHS.items()):
        table = columns(folder / f"{probe}.csv")
        moved = next(values for name, values in table.items() if name != "time")
        panel.plot(C * table["time"], 1e4 * moved, color=f"C{number}", lw=1.2, label=f"from x = {x}")
        panel.plot(C * table["time"], 1e4 * path(x, table["time"]), "k--", lw=0.7)
    panel.set(xlabel="c t / L", ylabel="displacement E / (f L)", title="Particle paths (dashed: exact)")
    panel.legend(frameon=False, fontsize=8, ncols=2)
    return figure


def impact(x, t, plastic):
    """Stress of the left bar at a time t after contact, while the fronts from the free end have not met
    those of the impact; x is measured from the plane of contact. `plastic` is what the stress is behind the plastic front,
    which runs at c/2 with hardening."""
    if plastic is None:
        return np.where((x < C * t) & (x < 1 - C * t), -10.0, 0.0)
    return np.where(x < C * t, -5.0, 0.0) + np.where(x < C * t / 2, plastic + 5.0, 0.0)


def figures_8_14_18(runner):
    kinds = (("figure_07_elastic_impact", "elastic (figures 8 to 10)", None, (0.0025, 0.0075)),
             ("figure_13_hardening_impact", "hardening (figure 14)", -7.5, (0.002, 0.004)),
             ("figure_17_perfectly_plastic_impact", "perfectly plastic (figure 18)", -5.0, (0.002, 0.004)))
    figure, grid = plt.subplots(2, 3, figsize=(9.6, 4.6), sharex=True, sharey=True, layout="constrained")
    for column, (scene, title, plastic, times) in zip(grid.T, kinds):
        for panel, time in zip(column, times):
            for number, contact in ((50, 2.45), (100, 2.475)):
                size = 0.5 / number
                for body, side in (("left", -1), ("right", 1)):
                    x, stress = runner.profile(scene, f"{scene}_{number}_{time}", body, contact + time,
                                               grid__cell_size=size)
                    panel.plot(x - 0.75, stress, f"C{number // 100}", lw=0.9,
                               label=f"{number} particles each" if side < 0 else None)
            x = np.linspace(0, 0.5, 1001)
            panel.plot(np.concatenate((-x[::-1], x)), np.concatenate((impact(x[::-1], time, plastic),
                       impact(x, time, plastic))), "k--", lw=0.8, label="exact")
            panel.set_title(f"{title}\n{time * C / 0.5:g} L/c after contact", fontsize=9)
        column[-1].set_xlabel("x from the middle")
    for panel in grid[:, 0]:
        panel.set_ylabel("stress")
    grid[0, 2].legend(frameon=False, fontsize=8, loc="lower center")
    grid[0, 0].set_ylim(-14, 4)
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path, help="where pictures and results go")
    parser.add_argument("--matpoint", default="matpoint", help="the program, by default the one in PATH")
    arguments = parser.parse_args()
    runner = Runner(arguments.matpoint, arguments.folder)
    arguments.folder.mkdir(parents=True, exist_ok=True)
    for name, draw in (("figure_02.png", figure_2), ("figure_05.png", figure_5),
                       ("figures_08_14_18.png", figures_8_14_18)):
        draw(runner).savefig(arguments.folder / name, dpi=80)
        print(arguments.folder / name)


if __name__ == "__main__":
    main()
