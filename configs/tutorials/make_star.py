#!/usr/bin/env python3
"""Writes star.csv, the particles of 05_own_particles.json: a star on a hexagonal lattice, spinning.

A particle's volume is the area of its lattice cell (per metre of depth), so that they add up to the star's.
"""

from math import atan2, cos, hypot, sqrt

distance = 0.0025  # between neighbours, m
centre = (0.0, 0.09)  # m
spin = -40.0  # rad/s
size = 0.045  # mean radius, m


def inside(x, y):
    return hypot(x, y) < size * (1 + 0.3 * cos(5 * (atan2(y, x) - atan2(1, 0))))


row = distance * sqrt(3) / 2
reach = int(1.5 * size / row)
with open("star.csv", "w") as table:
    table.write("x,y,volume,vx,vy\n")
    for j in range(-reach, reach + 1):
        for i in range(-reach, reach + 1):
            x, y = (i + 0.5 * (j % 2)) * distance, j * row
            if inside(x, y):
                table.write(f"{centre[0] + x:.6f},{centre[1] + y:.6f},{distance * row:.6e},{-spin * y:.4f},{spin * x:.4f}\n")
