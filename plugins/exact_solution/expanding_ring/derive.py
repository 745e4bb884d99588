#!/usr/bin/env python3
"""derive.py [--check]: the body force of the ring, derived as in appendix B of Wallstedt & Guilkey (2008).

Displacement, F, P and Div P are formed in Cartesian coordinates with sympy; the plugin balances forces along
the radius instead. Writes body_force.csv, which a test compares with the plugin; with --check, compares that file
with what it would write."""

import itertools
import sys
from pathlib import Path

import mpmath
import sympy as sp

TABLE = Path(__file__).parent / "body_force.csv"
COLUMNS = "youngs_modulus,density,inner_radius,outer_radius,amplitude,length,x,y,t,b_x,b_y"

E, RHO, RI, RO, A, LENGTH, X, Y, T = symbols = sp.symbols("E rho R_I R_0 A L X Y t", positive=True)
R = sp.Symbol("R", positive=True)

MATERIALS = [(10000, 1), ("2e5", 1200)]
RINGS = [("0.4", "0.6", "0.1", 1), ("0.1", "0.9", "0.05", 2), (0, 1, "0.2", 1)]
POINTS = [("0.3", "0.4"), ("-0.45", "0.1"), ("0.01", "-0.55")]
TIMES = [0, "0.003", "0.0172"]


def coefficients():
    """c1, c2, c3 of eq. 60: no strain along the radius at both surfaces, and u = 1 outside."""
    c = sp.symbols("c1:4")
    u = sum(ci * R**i for i, ci in enumerate(c, start=1))
    slope = sp.diff(u, R)
    solution = sp.solve([slope.subs(R, RI), slope.subs(R, RO), u.subs(R, RO) - 1], c, dict=True)[0]
    printed = [-6 * RI / (RO * (RO - 3 * RI)), 3 * (RO + RI) / (RO**2 * (RO - 3 * RI)), -2 / (RO**2 * (RO - 3 * RI))]
    assert all(sp.simplify(solution[ci] - p) == 0 for ci, p in zip(c, printed)), "eq. 61"
    return [solution[ci] for ci in c]


def body_force():
    """b = a - Div P / rho_0, eq. 52, with P of eq. 54 for nu = 0, where mu = E/2."""
    c1, c2, c3 = coefficients()
    radius = sp.sqrt(X**2 + Y**2)
    wave = A * sp.cos(sp.pi * sp.sqrt(E / RHO) * T / LENGTH)
    u = wave * (c3 * radius**2 + c2 * radius + c1) * sp.Matrix([X, Y])
    f = sp.eye(2) + u.jacobian([X, Y])
    p = E / 2 * (f - f.adjugate().T / f.det())
    divergence = sp.Matrix([sp.diff(p[i, 0], X) + sp.diff(p[i, 1], Y) for i in range(2)])
    return sp.diff(u, T, 2) - divergence / RHO


def table():
    b = sp.lambdify(symbols, body_force(), modules="mpmath")
    lines = [COLUMNS]
    with mpmath.workdps(40):
        for row in itertools.product(MATERIALS, RINGS, POINTS, TIMES):
            values = [*row[0], *row[1], *row[2], row[3]]
            exact = b(*(mpmath.mpf(str(v)) for v in values))
            lines.append(",".join([*map(str, values), *(format(float(v), ".15e") for v in exact)]))
    return "\n".join(lines) + "\n"


def main():
    if "--check" not in sys.argv[1:]:
        TABLE.write_text(table())
    elif TABLE.read_text() != table():
        sys.exit(f"{TABLE} is not what derive.py writes")


if __name__ == "__main__":
    main()
