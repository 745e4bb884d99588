#!/usr/bin/env python3
"""same_table.py A B TOLERANCE: two tables of particles agree, relative to the largest number of each quantity.

A quantity is a column or, for a vector or tensor, its columns (velocity_x, velocity_y)."""

import csv
import sys


def read(path):
    quantities = {}
    with open(path) as file:
        for row in csv.DictReader(file):
            for column, value in row.items():
                quantity = "position" if column in "xyz" else column.rsplit("_", 1)[0]
                quantities.setdefault(quantity, []).append(float(value))
    return quantities


a, b = read(sys.argv[1]), read(sys.argv[2])
assert a and a.keys() == b.keys(), f"{sys.argv[1]} and {sys.argv[2]} have different columns"
for quantity, values in a.items():
    assert len(values) == len(b[quantity]), f"{sys.argv[1]} and {sys.argv[2]} have different numbers of rows"
    largest = max(map(abs, values))
    difference = max(abs(x - y) for x, y in zip(values, b[quantity]))
    if difference > float(sys.argv[3]) * largest:
        sys.exit(f"{sys.argv[1]} and {sys.argv[2]}: {quantity} differs by {difference:.2g}, the largest is {largest:.2g}")
