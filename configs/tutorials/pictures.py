#!/usr/bin/python3
"""Makes the pictures of README.md, of the tutorials and of the wedge of verification/ma_2005 from runs of their scenes.

usage: pictures.py MATPOINT [NAME]...    (the executable; which pictures, all by default)

Needs the Debian packages python3-matplotlib and python3-vtk9.
"""

import csv
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from PIL import Image
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

HERE = Path(__file__).resolve().parent
PICTURES = HERE / "pictures"
COLOURS = matplotlib.colors.ListedColormap(matplotlib.colormaps["turbo"](np.linspace(0.1, 0.97, 256)))
KNOT = HERE.parent / "verification" / "stl_bounce" / "bounce.json"
WEDGE = HERE.parent / "verification" / "ma_2005" / "wedge.json"

plt.rcParams.update({"font.size": 10, "axes.titlesize": 10, "figure.titlesize": 12, "axes.spines.top": False,
                     "axes.spines.right": False, "figure.facecolor": "white"})


class Run:
    """A scene's results: particles by time, and probes."""

    def __init__(self, matpoint, scene, folder, *options):
        self.folder = folder
        subprocess.run([matpoint, "run", scene, "--output", folder, "--quiet", "--threads", "1", *options], check=True)

    def probe(self, name):
        with open(self.folder / f"{name}.csv", newline="") as stream:
            rows = np.array([[float(v) for v in row] for row in list(csv.reader(stream))[1:]])
        return rows[:, 0], rows[:, 1]

    def particles(self, time):
        """Points and fields of the file nearest to a time."""
        entries = ElementTree.parse(self.folder / "particles.pvd").getroot().findall("./Collection/DataSet")
        entry = min(entries, key=lambda e: abs(float(e.get("timestep")) - time))
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.folder / entry.get("file")))
        reader.Update()
        data = reader.GetOutput()
        arrays = data.GetPointData()
        fields = {arrays.GetArrayName(a): vtk_to_numpy(arrays.GetArray(a)).copy() for a in range(arrays.GetNumberOfArrays())}
        return vtk_to_numpy(data.GetPoints().GetData()).copy(), fields


def mises(stress):
    """Von Mises stress from components in VTK's order, xx yy zz xy yz xz."""
    xx, yy, zz, xy, yz, xz = stress.T
    return np.sqrt(((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) / 2 + 3 * (xy**2 + yz**2 + xz**2))


def save(figure, name, folder=PICTURES):
    folder.mkdir(exist_ok=True)
    file = folder / f"{name}.png"
    figure.savefig(file, dpi=110, bbox_inches="tight", pad_inches=0.08)
    plt.close(figure)
    Image.open(file).convert("RGB").quantize(128, dither=Image.Dither.NONE).save(file, optimize=True)
    print(f"{file}: {file.stat().st_size // 1000} kB")


def snapshots(run, times, value, label, limits, scale, unit, box, size, title, floor=True, mirrored=False):
    """Particles at several times, side by side, coloured by value(fields)."""
    left, right, bottom, top = box
    width = 10.0
    height = 0.84 * width / len(times) * (top - bottom) / (right - left)
    figure, axes = plt.subplots(1, len(times), figsize=(width, height + 0.95), sharey=True, layout="constrained")
    for axis, (time, text) in zip(axes, times):
        points, fields = run.particles(time)
        x, y = points[:, 0] * scale, points[:, 1] * scale
        c = value(fields)
        if mirrored:
            x, y, c = np.concatenate([x, -x]), np.concatenate([y, y]), np.concatenate([c, c])
        shown = axis.scatter(x, y, c=c, s=size, cmap=COLOURS, vmin=limits[0], vmax=limits[1], linewidths=0)
        if floor:
            axis.axhline(bottom, color="0.3", linewidth=3)
        axis.set(xlim=(left, right), ylim=(bottom, top), aspect="equal", title=text)
        axis.set_xlabel(unit)
        axis.locator_params(axis="x", nbins=4)
    axes[0].set_ylabel(unit)
    figure.colorbar(shown, ax=axes, label=label, pad=0.01)
    figure.suptitle(title)
    return figure


def pulled_bar(matpoint, folder):
    run = Run(matpoint, HERE / "01_pulled_bar.json", folder)
    time, end = run.probe("end")
    period = 4 / np.sqrt(200e9 / 7850)
    exact = np.abs((time / period) % 1 * 2 - 1)
    figure, axis = plt.subplots(figsize=(7, 2.8), layout="constrained")
    axis.plot(time * 1e3, (1 - exact), color="0.75", linewidth=5, label="exact: 2 p L / E there, and back")
    axis.plot(time * 1e3, end * 1e3, color="C0", linewidth=1.5, label="computed")
    axis.set(xlabel="time, ms", ylabel="displacement, mm", title="The end of a bar that is pulled suddenly", ylim=(-0.1, 1.45))
    axis.legend(frameon=False, loc="upper right", ncols=2)
    save(figure, "01_pulled_bar")


def bouncing_disk(matpoint, folder):
    run = Run(matpoint, HERE / "02_bouncing_disk.json", folder)
    times = [(t * 1e-3, f"{t} ms") for t in (0, 10, 20, 30, 50, 90)]
    save(snapshots(run, times, lambda f: mises(f["stress"]) / 1e3, "von Mises stress, kPa", (0, 80), 100, "cm",
                   (-6.5, 6.5, 0, 22), 4.5, "A rubber disk bounces"), "02_bouncing_disk")


def metal_impact(matpoint, folder):
    run = Run(matpoint, HERE / "03_metal_impact.json", folder)
    times = [(t * 1e-6, f"{t} μs") for t in (0, 10, 20, 40, 60, 80)]
    save(snapshots(run, times, lambda f: f["plastic_strain"], "plastic strain", (0, 2), 1e3, "mm", (-9, 9, 0, 34), 3,
                   "A copper rod hits a wall at 227 m/s", mirrored=True), "03_metal_impact")


def press(matpoint, folder):
    run = Run(matpoint, HERE / "04_press.json", folder)
    times = [(t * 1e-3, f"{t} ms") for t in (0, 50, 100, 150, 200)]
    save(snapshots(run, times, lambda f: mises(f["stress"]) / 1e3, "von Mises stress, kPa", (0, 60), 100, "cm",
                   (-7.5, 7.5, 0, 18.5), 4, "A stamp squeezes a ring"), "04_press")


def own_particles(matpoint, folder):
    run = Run(matpoint, HERE / "05_own_particles.json", folder)
    figure, axis = plt.subplots(figsize=(10, 3.4), layout="constrained")
    for time in (0, 0.065, 0.13, 0.19, 0.25):
        points, fields = run.particles(time)
        speed = np.linalg.norm(fields["velocity"], axis=1)
        shown = axis.scatter(points[:, 0] * 100, points[:, 1] * 100, c=speed, s=6, cmap=COLOURS, vmin=0, vmax=4, linewidths=0)
        axis.annotate(f"{time * 1e3:.0f} ms", (points[:, 0].mean() * 100, points[:, 1].max() * 100 + 0.6), ha="center")
    axis.axhline(0, color="0.3", linewidth=3)
    axis.set(aspect="equal", xlabel="cm", ylabel="cm", title="A spinning star of given particles", ylim=(0, None))
    figure.colorbar(shown, ax=axis, label="speed, m/s", pad=0.01)
    save(figure, "05_own_particles")


def contact(matpoint, folder):
    run = Run(matpoint, HERE / "06_contact.json", folder)
    times = [(t * 1e-3, f"{t} ms") for t in (0, 100, 300)]
    figure = snapshots(run, times, lambda f: mises(f["stress"]) / 1e3, "von Mises stress, kPa", (0, 30), 100, "cm",
                       (0, 60, 0, 20), 2.5, "A wheel drives a block")
    for axis, (time, _) in zip(figure.axes, times):
        height = 14.1 - 0.3 * (1 - np.cos(10 * np.pi * min(time, 0.1)))
        axis.add_patch(matplotlib.patches.Circle((20, height), 6, facecolor="0.85", edgecolor="0.3"))
    save(figure, "06_contact")


def levels(matpoint, folder):
    run = Run(matpoint, HERE / "07_levels.json", folder)
    points, fields = run.particles(1)
    x, y, level = points[:, 0] * 1e3, points[:, 1] * 1e3, fields["level"]
    figure, axes = plt.subplots(1, 2, figsize=(10, 4.4), layout="constrained")
    for axis, end, spot in ((axes[0], 50, 3.6), (axes[1], 22, 8.2)):
        drawn = axis.scatter(x, y, c=fields["stress"][:, 0] / 1e6, s=spot**2 / 4**level, cmap=COLOURS, vmin=-20, vmax=320, linewidths=0, marker="s")
        axis.set(xlim=(0, end), ylim=(0, end), aspect="equal", xlabel="mm")
    axes[0].set_ylabel("mm")
    figure.colorbar(drawn, ax=axes, label="stress xx, MPa", pad=0.01)
    figure.suptitle("A plate with a hole, drawn to the right with 100 MPa; cells of 2.5, 1.25 and 0.625 mm")
    save(figure, "07_levels")


def wedge(matpoint, folder):
    run = Run(matpoint, WEDGE, folder, "--set", "/grid/cell_size=250e-9", "--set",
              '/outputs=[{"type":"vtk","every":"100 ns","fields":["stress"]}]')
    points, fields = run.particles(100e-9)
    x, y = points[:, 0] * 1e6, points[:, 1] * 1e6
    xx, yy, zz, xy, yz, xz = fields["stress"].T / 1e9
    figure, axes = plt.subplots(1, 2, figsize=(10, 3.6), layout="constrained")
    shown = [(axes[0], yy, yy, (-4, 0), "stress yy, GPa", (-30, 30, 0, 44), 0.9), (axes[1], xy, -xy, (-2, 2), "stress xy, GPa", (-5, 5, 33.5, 41), 20)]
    for axis, right, left, limits, label, (x_min, x_max, y_min, y_max), size in shown:
        drawn = axis.scatter(np.concatenate([x, -x]), np.concatenate([y, y]), c=np.concatenate([right, left]), s=size, cmap=COLOURS,
                             vmin=limits[0], vmax=limits[1], linewidths=0, marker="s")
        tip, height = 40 - 0.45, 10
        across = height * np.tan(np.radians(68))
        axis.add_patch(matplotlib.patches.Polygon([(0, tip), (across, tip + height), (-across, tip + height)], facecolor="0.85", edgecolor="0.3"))
        axis.set(xlim=(x_min, x_max), ylim=(y_min, y_max), aspect="equal", xlabel="μm")
        figure.colorbar(drawn, ax=axis, label=label, pad=0.01, shrink=0.85)
    axes[0].set_ylabel("μm")
    figure.suptitle("A rigid wedge, 450 nm deep in aluminium")
    save(figure, "wedge", WEDGE.parent / "pictures")


def blurred(image, times):
    """Mean over a pixel and its neighbours, several times."""
    for _ in range(times):
        padded = np.pad(image, 1)
        image = sum(padded[1 + i : padded.shape[0] - 1 + i, 1 + j : padded.shape[1] - 1 + j] for i in (-1, 0, 1) for j in (-1, 0, 1)) / 9
    return image


def lit_balls(points, value, limits, view, corner, shape, pixel, radius):
    """An image (RGBA) of particles as balls, lit from the upper left, seen along view = (right, up, towards)."""
    across, height, depth = (points @ direction for direction in view)
    column, row = ((across - corner[0]) / pixel).astype(int), ((height - corner[1]) / pixel).astype(int)
    reach = int(radius / pixel)
    disk = [(i, j, np.sqrt(radius**2 - (i * i + j * j) * pixel**2)) for i in range(-reach, reach + 1) for j in range(-reach, reach + 1)
            if (i * i + j * j) * pixel**2 < radius**2]
    front, total, count = np.full(shape, -np.inf), np.zeros(shape), np.zeros(shape)
    for i, j, bulge in disk:
        np.maximum.at(front, (row + i, column + j), depth + bulge)
    for i, j, bulge in disk:
        seen = depth + bulge > front[row + i, column + j] - radius
        np.add.at(total, (row[seen] + i, column[seen] + j), value[seen])
        np.add.at(count, (row[seen] + i, column[seen] + j), 1)
    mask = count > 0
    surface = blurred(np.where(mask, front, 0), 3) / np.maximum(blurred(mask.astype(float), 3), 1e-9)
    slope_up, slope_right = np.gradient(surface, pixel)
    light = np.array([-0.45, 0.6, 0.66])
    shade = (light[2] - slope_right * light[0] - slope_up * light[1]) / np.sqrt(1 + slope_up**2 + slope_right**2)
    image = COLOURS((total / np.maximum(count, 1) - limits[0]) / (limits[1] - limits[0]))
    image[..., :3] *= (0.5 + 0.5 * np.clip(shade, 0, 1))[..., None]
    image[..., 3] = mask
    return image


def knot(matpoint, folder):
    run = Run(matpoint, KNOT, folder)
    turn, tilt = np.radians(-60), np.radians(30)
    right = np.array([np.cos(turn), np.sin(turn), 0])
    towards = np.array([np.sin(turn) * np.cos(tilt), -np.cos(turn) * np.cos(tilt), np.sin(tilt)])
    view = right, np.cross(towards, right), towards
    pixel, corner, shape = 0.03, (-6.0, -3.2), (360, 400)  # cm, cm, pixels
    extent = (corner[0], corner[0] + shape[1] * pixel, corner[1], corner[1] + shape[0] * pixel)
    figure, axes = plt.subplots(2, 3, figsize=(10, 5.4), layout="constrained")
    ground = np.array([[-4.5, -4.5, 0], [4.5, -4.5, 0], [4.5, 4.5, 0], [-4.5, 4.5, 0]])
    for axis, time in zip(axes.flat, (0, 0.008, 0.014, 0.024, 0.036, 0.05)):
        points, fields = run.particles(time)
        points = points * 100
        axis.fill(ground @ view[0], ground @ view[1], color="0.92", zorder=0)
        shadow = points * np.array([1, 1, 0])
        axis.scatter(shadow @ view[0], shadow @ view[1], color="0.78", s=4, linewidths=0, zorder=1)
        image = lit_balls(points, mises(fields["stress"]) / 1e3, (0, 40), view, corner, shape, pixel, 0.13)
        axis.imshow(image, origin="lower", extent=extent, zorder=2, interpolation="bilinear")
        axis.set(xlim=(-5.9, 5.9), ylim=(-3.0, 6.2), aspect="equal")
        axis.set_title(f"{time * 1e3:.0f} ms", y=0.92)
        axis.axis("off")
    scale = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(0, 40), COLOURS)
    figure.colorbar(scale, ax=axes, label="von Mises stress, kPa", shrink=0.8, pad=0.01)
    save(figure, "knot")


DRAWN = {"01_pulled_bar": pulled_bar, "02_bouncing_disk": bouncing_disk, "03_metal_impact": metal_impact, "04_press": press,
         "05_own_particles": own_particles, "06_contact": contact, "07_levels": levels, "knot": knot, "wedge": wedge}


def main(matpoint, *names):
    for name in names or DRAWN:
        with tempfile.TemporaryDirectory() as folder:
            DRAWN[name](str(Path(matpoint).resolve()), Path(folder) / name)


main(*sys.argv[1:])
