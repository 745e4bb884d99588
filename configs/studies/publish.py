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
    "free_disk": ({"dimension": 2, "mode": "plane_strain", "bodies": 1, "material": "neo_hookean",
                   "exact_solution": "free_disk_vibration", "general": False}, 2.0),
    "flying_disk": ({"dimension": 2, "mode": "plane_strain", "bodies": 1, "material": "neo_hookean",
                     "exact_solution": "free_disk_vibration", "general": False}, 2.0),
    "spinning_disk": ({"dimension": 2, "mode": "plane_strain", "bodies": 1, "material": "neo_hookean",
                       "exact_solution": "spinning_disk", "general": False}, 2.0),
}
SHORT = {"central_difference": "central difference", "affine_flip": "affine flip"}
DEFAULT = ("bspline 2", "central difference", "affine flip")


def scheme(settings):
    """gimp contiguous, usl, flip enhanced"""
    shape, transfer = settings["/shape_function"], settings["/transfer"]
    words = [shape["type"]] + [str(shape[k]) for k in ("domain", "order") if k in shape]
    integrator = settings["/integrator/type"]
    return (" ".join(words), SHORT.get(integrator, integrator),
            SHORT.get(transfer["type"], transfer["type"]) + (" enhanced" if transfer.get("gradient_enhanced") else ""))


def particles(settings):
    """A cell."""
    return next(v for k, v in settings.items() if k.endswith("particles_per_cell"))


def front(rows):
    """The cheapest in particle steps first, each more accurate than those before it."""
    best, kept = float("inf"), []
    for row in sorted(rows, key=lambda r: (r["particle_steps"], r["error"])):
        if row["error"] < best:
            best = row["error"]
            kept.append(row)
    return kept


def table(rows, side):
    lines = ["| error | particle steps | CPU s | shape | integrator | transfer | cells across | particles a cell |",
             "|---|---|---|---|---|---|---|---|"]
    for r in rows:
        settings = r["settings"]
        cells = [f'{r["error"]:.2g}', f'{r["particle_steps"]:.2g}', f'{r["cpu_seconds"]:.2g}', *scheme(settings),
                 f'{side / settings["/grid/cell_size"]:.3g}', str(particles(settings))]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


def finest(rows):
    """The rows on the finest grid with the fewest particles a cell, by scheme."""
    least = min((r["settings"]["/grid/cell_size"], particles(r["settings"])) for r in rows)
    return {scheme(r["settings"]): r for r in rows if (r["settings"]["/grid/cell_size"], particles(r["settings"])) == least}


def table_of_schemes(rows):
    cell = {}
    for (shape, integrator, transfer), r in finest(rows).items():
        done = r["status"] == "completed" and r["error"] is not None
        cell[shape, f"{integrator}, {transfer}"] = f'{r["error"]:.2g}' if done else "breaks down" if r["status"] != "refused" else "–"
    shapes, schemes = (list(dict.fromkeys(names)) for names in zip(*cell))
    lines = ["| scheme | " + " | ".join(shapes) + " |", "|---|" + "---|" * len(shapes)]
    lines += [f"| {name} | " + " | ".join(cell[shape, name] for shape in shapes) + " |" for name in schemes]
    return "\n".join(lines)


def beside_the_best(title, rows):
    """What the default loses against the best on the finest grid."""
    done = {name: r["error"] for name, r in finest(rows).items() if r["status"] == "completed" and r["error"] is not None}
    best = min(done, key=done.get)
    return f'| {title} | {done[DEFAULT]:.2g} | {done[best]:.2g} | {", ".join(best)} | {done[DEFAULT] / done[best]:.2g} |'


def put(text, marker, content):
    begin, end = f"<!-- begin {marker} -->", f"<!-- end {marker} -->"
    pattern = re.compile(re.escape(begin) + ".*?" + re.escape(end), re.S)
    if not pattern.search(text):
        sys.exit(f"{PAGE}: there is no {begin}")
    return pattern.sub(lambda _: f"{begin}\n{content}\n{end}", text)


def main():
    results = pathlib.Path(sys.argv[1])
    page = PAGE.read_text()
    losses = ["| study | default | best | which | times as large |", "|---|---|---|---|---|"]
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
        page = put(page, f"{name} schemes", table_of_schemes(study["variants"]))
        losses.append(beside_the_best(f"`{name}`", study["variants"]))
        broken = sum(r["status"] in ("broke_down", "crashed") for r in study["variants"])
        page = put(page, f"{name} counts", f'{len(study["variants"])} variants, of which {len(done)} completed, {broken} broke down and '
                   f'{sum(r["status"] == "refused" for r in study["variants"])} are combinations that the components refuse.')
    PAGE.write_text(put(page, "losses", "\n".join(losses)))


main()
