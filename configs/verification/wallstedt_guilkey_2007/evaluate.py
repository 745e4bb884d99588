#!/usr/bin/python3
"""Prints the figures of README.md that are taken from many runs.

usage: evaluate.py FOLDER     (where `make` put the results of the studies; needs Debian's python3-numpy)
"""

import json
import pathlib
import sys

import numpy as np

from projection import largest_error

NUMBER = "/bodies/bar/geometry/counts/0"


def lines(study):
    """For each variant of a study the varied value and the error, NaN where it broke down."""
    found = {}
    for row in json.loads(study.read_text())["variants"]:
        value = row["settings"].get(NUMBER) or row["settings"]["/grid/cell_size"]
        found.setdefault(row["variant"], []).append((value, np.nan if row["error"] is None else row["error"]))
    return {name: tuple(np.array(rows).T) for name, rows in found.items()}


def projection(folder, figure, power):
    for name, (number, error) in lines(folder / figure / "study.json").items():
        shape, enhanced = name.split(",")[0], "enhanced" in name
        direct = np.array([largest_error(shape, power, enhanced, int(n)) for n in number])
        print(f"{figure} {name}: at most {max(abs(error - direct)):.1e} from projection.py; largest {max(error):.3g}")
        if power == 1 and not enhanced:
            fits = number % 50 == 0
            print(f"  largest at integer and half-integer PPC: {max(error[fits]):.1e}")
            # The largest error between one such PPC and the next.
            peaks = [max(zip(error[part], number[part])) for k in range(2, 20)
                     for part in [(number > 50 * k) & (number < 50 * (k + 1))]]
            heights, places = np.array(peaks).T
            print(f"  slope of the local maxima: {np.polyfit(np.log(places), np.log(heights), 1)[0]:.2f}")
        if power == 2:
            plateau = 1e-4 / 6 / 1.01**2
            beyond = number[error > 1.25 * plateau]
            print(f"  N = 1000: {error[-1]:.4g}, plateau {plateau:.4g}; within 25 % of it from PPC {max(beyond, default=0) / 100:g} on")


def meshes(folder):
    for name, (_, error) in lines(folder / "figure_10" / "study.json").items():
        h = float(name.split()[-1])
        print(f"figure_10 {name}: {error[-1]:.4g}, plateau {h * h / 6 / (1 + h)**2:.4g}")


def sudden_stop(folder):
    errors = {name: error for name, (_, error) in lines(folder / "figure_12" / "study.json").items()}
    for name, error in errors.items():
        done = error[~np.isnan(error)]
        print(f"figure_12 {name}: median {np.median(done):.4f}, 5 to 95 %: {np.percentile(done, 5):.3f} to "
              f"{np.percentile(done, 95):.3f}, largest {max(done):.3f}; {sum(np.isnan(error))} of {len(error)} broke down")
    for name in ("gimp", "linear"):
        print(f"figure_12 gimp, enhanced is lower than {name} by {100 * np.nanmedian(1 - errors['gimp, enhanced'] / errors[name]):.0f} %"
              " (median over PPC)")


def convergence(folder, figure):
    found = lines(folder / figure / "study.json")
    for name, (_, error) in found.items():
        print(f"{figure} {name}: " + ", ".join(f"{e:.3g}" for e in error))
        if f"{name}, enhanced" in found:
            print("  enhanced lower by " + ", ".join(f"{100 * r:.0f}" for r in 1 - found[f"{name}, enhanced"][1] / error) + " %")


def main():
    folder = pathlib.Path(sys.argv[1])
    projection(folder, "figure_05", 1)
    projection(folder, "figure_06", 2)
    meshes(folder)
    sudden_stop(folder)
    for figure in ("figure_13", "figure_15", "figure_15_small"):
        convergence(folder, figure)


if __name__ == "__main__":
    main()
