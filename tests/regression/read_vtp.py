"""Reads with VTK what the output `vtk` wrote, and compares it with what `csv` wrote in the same run.

usage: read_vtp.py FOLDER NAME BODY    (files NAME.pvd and NAME_BODY_000000.csv, … of one body)
"""

import csv
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

# Place of a component in VTK's arrays; matrices are written by row.
PLACES = {"vector": ["x", "y", "z"], "symmetric": ["xx", "yy", "zz", "xy", "yz", "xz"],
          "matrix": ["xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"]}
SHAPES = {1: [""], 3: PLACES["vector"], 6: PLACES["symmetric"], 9: PLACES["matrix"]}


def read_vtp(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    assert reader.GetErrorCode() == 0, f"{path}: VTK error {reader.GetErrorCode()}"
    return reader.GetOutput()


def read_table(path):
    with open(path, newline="") as stream:
        return list(csv.DictReader(stream))


def compare(data, rows, path):
    assert data.GetNumberOfPoints() == data.GetNumberOfVerts() == len(rows) > 0, f"{path}: number of points"
    compared = {"x", "y", "z"} & set(rows[0])
    for p, row in enumerate(rows):
        point = data.GetPoint(p)
        for axis, value in zip("xyz", point):
            assert value == float(row.get(axis, 0)), f"{path}: {axis} of point {p}"
    arrays = data.GetPointData()
    for a in range(arrays.GetNumberOfArrays()):
        array = arrays.GetArray(a)
        if array.GetName() == "body":
            continue
        for c, suffix in enumerate(SHAPES[array.GetNumberOfComponents()]):
            column = f"{array.GetName()}_{suffix}" if suffix else array.GetName()
            for p, row in enumerate(rows):
                value = array.GetComponent(p, c)
                assert value == float(row.get(column, 0)), f"{path}: {column} of point {p}: {value}"
            compared.add(column)
    left = set(rows[0]) - compared
    assert not left, f"{path}: not in the VTK file: {left}"


def main(folder, name, body):
    folder = Path(folder)
    times = read_table(folder / f"{name}_times.csv")
    series = ElementTree.parse(folder / f"{name}.pvd").getroot().findall("./Collection/DataSet")
    assert [float(s.get("timestep")) for s in series] == [float(t["time"]) for t in times], "times differ"
    for time, entry in zip(times, series):
        path = folder / entry.get("file")
        data = read_vtp(path)
        assert data.GetFieldData().GetArray("TimeValue").GetValue(0) == float(time["time"]), f"{path}: time"
        compare(data, read_table(folder / f"{name}_{body}_{int(time['index']):06}.csv"), path)
    print(f"VTK {vtkVersion().GetVTKVersion()}: {len(series)} files agree with the tables")


main(*sys.argv[1:])
