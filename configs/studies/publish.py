#!/usr/bin/env python3
"""Publishes what `matpoint study` measured: publish.py RESULTS, with RESULTS/<study>/study.json.

Writes fronts/<study>.json (what the scene key `accuracy` is answered from), copies the plot, and writes the tables of
framework/docs/what_accuracy_costs.md anew, between their markers."""
import json
import pathlib
import re
import shutil
import sys

HERE = pathlib.Path(__file__).resolve().parent
PAGE = HERE.parents[1] / "framework/docs/what_accuracy_costs.md"

# What a study's scene is like, and the smallest side of its bodies, m.
ABOUT = {
    "axis_aligned_vibration": ({"dimension": 2, "mode": "plane_strain", "bodies": 1, "material": "neo_hookean",
                                "exact_solution": "axis_aligned_vibration", "general": False}, 1.0),
    "expanding_ring": ({"dimension": 2, "mode": "plane_strain", "bodies": 1, "material": "neo_hookean",
                        "exact_solution": "expanding_ring", "general": True}, 0.2),
    "vibrating_block": ({"dimension": 3, "mode": "solid", "bodies": 1, "material": "neo_hookean",
                         "exact_solution": "axis_aligned_vibration", "general": True}, 1.0),
    "impact": ({"dimension": 1, "mode": "bar", "bodies": 2, "material": "linear_elastic",
                "exact_solution": "bar_impact", "general": True}, 0.5),
}
SHORT = {"central_difference": "central difference"}


def scheme(settings):
    """gimp contiguous, usl, flip enhanced"""
    shape, transfer = settings["/shape_function"], settings["/transfer"]
    words = [shape["type"]] + [str(shape[k]) for k in ("domain", "order") if k in shape]
    integrator = settings["/integrator/type"]
    return (" ".join(words), SHORT.get(integrator, integrator),
            transfer["type"] + (" enhanced" if transfer.get("gradient_enhanced") else ""))


def others(settings, side):
    """cells across, particles a cell, CFL, precision"""
    particles = next(v for k, v in settings.items() if k.endswith("particles_per_cell"))
    return (f'{side / settings["/grid/cell_size"]:.3g}', str(particles), str(settings["/time/cfl"]), settings["/space/precision"])


def front(rows):
    """The cheapest in particle steps first, each more accurate than those before it."""
    best, kept = float("inf"), []
    for row in sorted(rows, key=lambda r: (r["particle_steps"], r["error"])):
        if row["error"] < best:
            best = row["error"]
            kept.append(row)
    return kept


def table(rows, side):
    lines = ["| error | particle steps | CPU s | shape | integrator | transfer | cells across | particles a cell | CFL | precision |",
             "|---|---|---|---|---|---|---|---|---|---|"]
    for r in rows:
        cells = [f'{r["error"]:.2g}', f'{r["particle_steps"]:.2g}', f'{r["cpu_seconds"]:.2g}', *scheme(r["settings"]), *others(r["settings"], side)]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


def best_by_scheme(rows, side):
    """For each scheme the smallest error on the finest grid, with 4 (or the fewest) particles a cell and CFL 0.4."""
    finest = min(r["settings"]["/grid/cell_size"] for r in rows)
    fewest = min(next(v for k, v in r["settings"].items() if k.endswith("particles_per_cell")) for r in rows)
    shapes, columns, cell = [], [], {}
    for r in rows:
        s = r["settings"]
        particles = next(v for k, v in s.items() if k.endswith("particles_per_cell"))
        if (s["/grid/cell_size"], particles, s["/time/cfl"], s["/space/precision"]) != (finest, fewest, 0.4, "double"):
            continue
        shape, integrator, transfer = scheme(s)
        column = f"{integrator}, {transfer}"
        shapes += [shape] * (shape not in shapes)
        columns += [column] * (column not in columns)
        cell[shape, column] = f'{r["error"]:.2g}' if r["status"] == "completed" and r["error"] is not None else "breaks down" if r["status"] != "refused" else "–"
    lines = ["| scheme | " + " | ".join(shapes) + " |", "|---|" + "---|" * len(shapes)]
    for column in columns:
        lines.append(f"| {column} | " + " | ".join(cell.get((shape, column), "–") for shape in shapes) + " |")
    return "\n".join(lines)


def put(text, marker, content):
    begin, end = f"<!-- begin {marker} -->", f"<!-- end {marker} -->"
    pattern = re.compile(re.escape(begin) + ".*?" + re.escape(end), re.S)
    if not pattern.search(text):
        sys.exit(f"{PAGE}: there is no {begin}")
    return pattern.sub(lambda _: f"{begin}\n{content}\n{end}", text)


def main():
    results = pathlib.Path(sys.argv[1])
    page = PAGE.read_text()
    for name, (about, side) in ABOUT.items():
        study = json.loads((results / name / "study.json").read_text())
        done = [r for r in study["variants"] if r["status"] == "completed" and r["error"] is not None]
        kept = front(done)
        rows = [{"error": r["error"], "particle_steps": r["particle_steps"], "cells": side / r["settings"]["/grid/cell_size"],
                 "settings": {k: v for k, v in r["settings"].items() if k != "/grid/cell_size"}} for r in kept]
        (HERE / "fronts").mkdir(exist_ok=True)
        (HERE / "fronts" / f"{name}.json").write_text(
            json.dumps({"title": study["title"], "about": about, "front": rows}, indent=1) + "\n")
        (HERE / "pictures").mkdir(exist_ok=True)
        shutil.copy(results / name / "cost.svg", HERE / "pictures" / f"{name}.svg")
        page = put(page, f"{name} front", table(kept, side))
        page = put(page, f"{name} schemes", best_by_scheme(study["variants"], side))
        broken = sum(r["status"] in ("broke_down", "crashed") for r in study["variants"])
        page = put(page, f"{name} counts", f'{len(study["variants"])} variants, of which {len(done)} completed, {broken} broke down and '
                   f'{sum(r["status"] == "refused" for r in study["variants"])} are combinations that the components refuse.')
    PAGE.write_text(page)


main()
