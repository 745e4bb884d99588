#!/usr/bin/env python3
"""Makes the table of schemes of framework/docs/decisions/default_scheme.md anew: runs the scenes of this folder and tutorial 02 with
each scheme, and writes the table between its markers. A quarter of an hour on one core; interrupt it, and it goes on.

usage: schemes.py FOLDER [PROGRAM]     (where results go; matpoint, by default the one in PATH)"""
import csv
import json
import math
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
PAGE = ROOT / "framework/docs/decisions/default_scheme.md"
PERIOD, FREQUENCY = 2.955758, 2.125749  # of the disk's mode, s, and 1/s

QUADRATIC = {"type": "bspline", "order": 2}


def gimp(domain):
    return {"type": "gimp", "domain": domain}


def scheme(shape=QUADRATIC, transfer="affine_flip", integrator="central_difference", particles=9, **more):
    return {"/shape_function": shape, "/transfer": {"type": transfer, **more}, "/integrator": {"type": integrator},
            "particles_per_cell": particles}


SCHEMES = {
    "**quadratic, affine flip 0.01, central difference**": scheme(),
    "the same, 4 particles a cell": scheme(particles=4),
    "the same, `pic_fraction` 0.05": scheme(pic_fraction=0.05),
    "the same, `uvf`": scheme(integrator="uvf"),
    "the same, `musl`": scheme(integrator="musl"),
    "the same, `usf`": scheme(integrator="usf"),
    "the same, `usavg`": scheme(integrator="usavg"),
    "the same, `lagged_strain`": scheme(integrator="lagged_strain"),
    "quadratic, apic, central difference": scheme(transfer="apic"),
    "quadratic, flip, central difference": scheme(transfer="flip"),
    "quadratic, fmpm 2, central difference": scheme(transfer="fmpm", order=2),
    "quadratic, fmpm 4, central difference": scheme(transfer="fmpm", order=4),
    "quadratic, fmpm 2, `usavg`": scheme(transfer="fmpm", order=2, integrator="usavg"),
    "quadratic, fmpm 4, `usavg`": scheme(transfer="fmpm", order=4, integrator="usavg"),
    "contiguous gimp, affine flip 0.01, central difference": scheme(gimp("contiguous")),
    "stretched gimp, the same": scheme(gimp("stretched")),
    "contiguous gimp, flip, musl": scheme(gimp("contiguous"), "flip", "musl"),
}


def state(folder, which):
    """Frames of the csv output `state` of the disk: of each its time, and rows of numbers by column."""
    with open(folder / "state_times.csv") as file:
        times = [float(row["time"]) for row in csv.DictReader(file)]
    for index in which:
        index %= len(times)
        with open(folder / f"state_disk_{index:06d}.csv") as file:
            yield times[index], [{k: float(v) for k, v in row.items()} for row in csv.DictReader(file)]


def probe(folder, name):
    with open(folder / f"{name}.csv") as file:
        return [tuple(map(float, row)) for row in list(csv.reader(file))[1:]]


def vibration(drift):
    """Amplitude, noise and lag in the last period. The mode's shape U is that of the velocities of the start; displacements have
    a sin(wt - lag) of it, velocities a cos(wt - lag). Noise: the rest of the velocity, over the mode's largest speed."""
    def measure(folder):
        (_, start), *last = state(folder, (0, -3, -2, -1))  # a third of a period apart: sin^2, cos^2 and their product have their means
        shape = [(p["velocity_x"] - drift[0], p["velocity_y"] - drift[1]) for p in start]
        mass = [p["mass"] for p in start]
        largest = max(math.hypot(*u) for u in shape)
        norm = sum(m * (u * u + v * v) for m, (u, v) in zip(mass, shape))
        squares, rest, lags = 0, 0, 0
        for time, now in last:
            moved = [(p["x"] - q["x"] - drift[0] * time, p["y"] - q["y"] - drift[1] * time) for p, q in zip(now, start)]
            speed = [(p["velocity_x"] - drift[0], p["velocity_y"] - drift[1]) for p in now]
            share = [sum(m * (a * u + b * v) for m, (a, b), (u, v) in zip(mass, motion, shape)) / norm for motion in (moved, speed)]
            sine, cosine = FREQUENCY * share[0], share[1]
            squares += sine**2 + cosine**2
            lags += math.remainder(FREQUENCY * time - math.atan2(sine, cosine), 2 * math.pi)
            rest += sum(m * ((a - cosine * u)**2 + (b - cosine * v)**2)
                        for m, (a, b), (u, v) in zip(mass, speed, shape)) / sum(mass)
        return f"{math.sqrt(squares / len(last)):.3f} / {math.sqrt(rest / len(last)) / largest:.3f} / {lags / len(last):.2f}"
    return measure


def spin(folder):
    """Angular momentum, and the radius by the moment of inertia, over those of the start."""
    def sums(rows):
        return (sum(p["mass"] * (p["x"] * p["velocity_y"] - p["y"] * p["velocity_x"]) for p in rows),
                sum(p["mass"] * (p["x"]**2 + p["y"]**2) for p in rows))
    (momentum0, inertia0), (momentum, inertia) = (sums(rows) for _, rows in state(folder, (0, -1)))
    return f"{momentum / momentum0:.4f}, {math.sqrt(inertia / inertia0):.4f}"


def deflection(folder):
    """Mean over the time in which the load is constant, over the length."""
    tip = [y for time, y in probe(folder, "tip") if time >= 2500]
    return f"{-sum(tip) / len(tip) / 10:.4f}"


def bounces(folder):
    """Kinetic and strain energy and that of the height, at the top of the flight after the sixth bounce, over those of the start."""
    height, energy = probe(folder, "height"), probe(folder, "energy")
    y = [row[1] for row in height]
    contacts = [i for i in range(1, len(y) - 1) if y[i] == min(y[max(0, i - 30):i + 31]) and y[i] < y[i - 1]]  # lowest within 30 ms
    if len(contacts) < 7:
        return f"{len(contacts)} bounces"
    top = max(range(contacts[5], contacts[6]), key=lambda i: y[i])
    fall = math.pi * 0.05**2 * 1000 * 9.81 * 0.01  # J, from the start to the floor
    return f"{(energy[top][1] + fall) / (energy[0][1] + fall):.2f}"


HEALTH = {"unstable_step": "ignore", "energy_gain": 1e9}
STATE = {"type": "csv", "name": "state", "fields": ["velocity", "mass"], "precision": 12}
DISK = {"/time/end": 50 * PERIOD, "/outputs": [{**STATE, "every": PERIOD / 3}], "/health": HEALTH}
TIP = {"/grid/cell_size": 0.25, "/health": HEALTH}
# Column, scene, body, what is set beside the scheme, and how it is measured.
COLUMNS = [
    ("disk at rest", HERE / "free_disk.json", "disk", DISK, vibration((0, 0))),
    ("drifting", HERE / "free_disk.json", "disk",
     {**DISK, "/exact_solution/drift": [0.1, 0.03], "/grid/max": [16.5, 6.5]}, vibration((0.1, 0.03))),
    ("spin", HERE / "spinning_disk.json", "disk", {"/outputs": [{**STATE, "every": 1000}], "/health": HEALTH}, spin),
    ("cantilever", HERE / "cantilever.json", "beam", TIP, deflection),
    ("load 3", HERE / "cantilever.json", "beam", {**TIP, "/loads/0/traction": [0, -2.5e-3]}, deflection),
    ("bounces", ROOT / "configs/tutorials/02_bouncing_disk.json", "disk",
     {"/time/end": 3.2, "/grid/max": [0.1, 2], "/health": HEALTH,
      "/outputs": [{"type": "probe", "name": "height", "quantity": "centroid", "component": "y", "every": 1e-3},
                   {"type": "probe", "name": "energy", "quantity": "total_energy", "every": 1e-3}]}, bounces),
]


def run(folder, program, column, scene, body, settings):
    """The study of a column: its rows by scheme."""
    variants = {name: {(key if key[0] == "/" else f"/bodies/{body}/{key}"): value for key, value in values.items()}
                for name, values in SCHEMES.items()}
    study = {"title": column, "scene": str(scene), "set": settings, "variants": variants, "keep_outputs": True,
             "accuracy": {"summary": "/conservation/energy_drift"}}
    name = column.replace(" ", "_")
    path = folder / f"{name}.study.json"
    path.write_text(json.dumps(study, indent=1))
    subprocess.run([program, "study", path, "--output", folder / name, "--quiet"], check=True)
    return {row["variant"]: row for row in json.loads((folder / name / "study.json").read_text())["variants"]}


def main():
    folder = pathlib.Path(sys.argv[1]).resolve()
    program = sys.argv[2] if len(sys.argv) > 2 else "matpoint"
    folder.mkdir(parents=True, exist_ok=True)
    cells = {name: [] for name in SCHEMES}
    for column, scene, body, settings, measure in COLUMNS:
        for name, row in run(folder, program, column, scene, body, settings).items():
            found = "breaks down" if row["status"] != "completed" else measure(folder / column.replace(" ", "_") / row["folder"])
            cells[name].append(found)
            print(f"{column}, {name}: {found}", flush=True)
    names = [column for column, *_ in COLUMNS]
    lines = ["| scheme | " + " | ".join(names) + " |", "|---|" + "---|" * len(names)]
    lines += [f"| {name} | " + " | ".join(row) + " |" for name, row in cells.items()]
    begin, end = "<!-- begin schemes -->", "<!-- end schemes -->"
    before, rest = PAGE.read_text().split(begin)
    PAGE.write_text(before + begin + "\n" + "\n".join(lines) + "\n" + end + rest.split(end)[1])


main()
