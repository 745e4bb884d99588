#!/usr/bin/python3
"""Draws figure 11 of Wallstedt & Guilkey (2007): the stopped bar's displacement at four places over two periods.

usage: plot.py PICTURE.svg RUN_FOLDER     (the folder of a run of figure_11_sudden_stop.json; needs Debian's python3-matplotlib)
"""

import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

PLACES = {"x_0250": 25, "x_0495": 50, "x_0750": 76, "x_1000": 101}  # probes and their particles, of 102


def exact(x, t):
    """d'Alembert's solution by the triangle wave of period 4 (v_0 = L = 1, c = 100)."""

    def triangle(s):
        return abs((s + 2) % 4 - 2)

    return (triangle(x + 100 * t) - triangle(x - 100 * t)) / 200


def main():
    picture, folder = map(pathlib.Path, sys.argv[1:])
    plt.rcParams["svg.hashsalt"] = "figure_11"
    figure, panel = plt.subplots(figsize=(7.2, 3.6), layout="constrained")
    for number, (probe, particle) in enumerate(PLACES.items()):
        time, moved = np.loadtxt(folder / f"{probe}.csv", delimiter=",", skiprows=1).T
        x = (particle + 0.5) / 102
        panel.plot(100 * time, 100 * moved, color=f"C{number}", lw=1.2, label=f"X = {x:.3f}")
        panel.plot(100 * time, 100 * exact(x, time), "k--", lw=0.7)
    panel.set(xlabel="c t / L", ylabel="u c / (v₀ L)", title="Displacement of the stopped bar (dashed: exact)")
    panel.legend(frameon=False, fontsize=8, ncols=4, loc="lower center")
    panel.set_ylim(-1.35, 1.1)
    figure.savefig(picture, metadata={"Date": None})


if __name__ == "__main__":
    main()
