#!/usr/bin/env python3
"""Writes trefoil.stl: a tube around a trefoil knot, as a closed binary STL surface.

The knot is the standard parametrisation of the (2,3) torus knot,
    x = sin t + 2 sin 2t,  y = cos t - 2 cos 2t,  z = -sin 3t,  0 <= t < 2 pi
(Weisstein, E. W., "Trefoil Knot", MathWorld), in centimetres. Around it lie circles of radius 0.6 in
the plane of its normal and binormal. As the radius is less than the knot's radius of curvature, the
tube's volume is pi r^2 L (theorem of Pappus); the printed volumes tell how near the mesh comes.
"""

import math
import pathlib
import struct

RADIUS = 0.6
RINGS = 240
SEGMENTS = 16


def position(t):
    return (math.sin(t) + 2 * math.sin(2 * t), math.cos(t) - 2 * math.cos(2 * t), -math.sin(3 * t))


def velocity(t):
    return (math.cos(t) + 4 * math.cos(2 * t), -math.sin(t) + 4 * math.sin(2 * t), -3 * math.cos(3 * t))


def acceleration(t):
    return (-math.sin(t) - 8 * math.sin(2 * t), -math.cos(t) + 8 * math.cos(2 * t), 9 * math.sin(3 * t))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def unit(a):
    length = math.sqrt(dot(a, a))
    return tuple(x / length for x in a)


def ring(t):
    tangent = unit(velocity(t))
    binormal = unit(cross(velocity(t), acceleration(t)))
    normal = cross(binormal, tangent)
    corners = []
    for k in range(SEGMENTS):
        angle = 2 * math.pi * k / SEGMENTS
        corner = (p + RADIUS * (math.cos(angle) * n + math.sin(angle) * b)
                  for p, n, b in zip(position(t), normal, binormal))
        # Rounded as the file holds them, so that triangles share corners to the bit.
        corners.append(struct.unpack("<3f", struct.pack("<3f", *corner)))
    return corners


def tube():
    rings = [ring(2 * math.pi * i / RINGS) for i in range(RINGS)]
    triangles = []
    for i in range(RINGS):
        here, there = rings[i], rings[(i + 1) % RINGS]
        for k in range(SEGMENTS):
            next_k = (k + 1) % SEGMENTS
            triangles.append((here[k], here[next_k], there[next_k]))
            triangles.append((here[k], there[next_k], there[k]))
    return triangles


def write_stl(path, triangles):
    with open(path, "wb") as file:
        file.write(b"Trefoil knot tube, made by make_mesh.py; unit: cm".ljust(80))
        file.write(struct.pack("<I", len(triangles)))
        for a, b, c in triangles:
            edges = [tuple(x - y for x, y in zip(p, a)) for p in (b, c)]
            file.write(struct.pack("<12fH", *unit(cross(*edges)), *a, *b, *c, 0))


def main():
    triangles = tube()
    mesh_volume = sum(dot(a, cross(b, c)) for a, b, c in triangles) / 6
    steps = 100000
    length = sum(math.sqrt(dot(velocity(t), velocity(t)))
                 for t in (2 * math.pi * i / steps for i in range(steps))) * 2 * math.pi / steps
    corners = [corner for triangle in triangles for corner in triangle]
    write_stl(pathlib.Path(__file__).with_name("trefoil.stl"), triangles)
    print(f"{len(triangles)} triangles, volume {mesh_volume:.4f}, of the smooth tube {math.pi * RADIUS**2 * length:.4f}")
    print("from", [round(min(c[a] for c in corners), 4) for a in range(3)],
          "to", [round(max(c[a] for c in corners), 4) for a in range(3)])


if __name__ == "__main__":
    main()
