#!/usr/bin/env python3
"""Users' plugins are as fast as those of Matpoint, by instructions per particle and step: a shape function of a few lines within
2 % of `bspline`, a material that is a plain function of one particle within 1.5 times of one tuned by hand. All give the results of
the built-in ones.

usage: user_plugins_test.py MATPOINT    (bin/matpoint of a build tree or of an installation)"""
import re
import sys
import tempfile
from pathlib import Path

from callgrind import counted_instruction_set, instructions_per_step
from runs import call
from user_plugins import MATERIALS, build_plugins, variants

SHAPE_LIMIT, MATERIAL_LIMIT = 1.02, 1.5
TOLERANCE = 1e-12  # of energies after twelve steps; terms are formed in another order
PACKED_PART = 0.95
OPERATION = re.compile(r"\tv?(?:add|sub|mul|div|sqrt|fn?m(?:add|sub)\d*)([ps])d\s")
CODE = re.compile(r"^[0-9a-f]+ <(.*)>:\n((?:.+\n)*)", re.MULTILINE)


def packed_part(library):
    """How much of a material's arithmetic in 3D, double precision, acts on several numbers at once."""
    text = call(["objdump", "-d", "--demangle", "--no-show-raw-insn", library]).stdout
    widths = [width for function, code in CODE.findall(text) if "Rubber<matpoint::Space<3, (matpoint::Mode)3, double>" in function
              for width in OPERATION.findall(code)]
    return widths.count("p") / len(widths)


def mistakes(program, folder):
    instruction_set = counted_instruction_set(program)
    plugins = build_plugins(program, instruction_set, folder)
    counts, energies = {}, {}
    for name, values in ({"built-in": {}} | variants(plugins)).items():
        counts[name], summary = instructions_per_step(program, "block_quadratic", values)
        energies[name] = [summary["final"][energy] for energy in ("kinetic_energy", "strain_energy")]
        print(f"{name}: {counts[name]:.1f} instructions per particle and step")
    for name, own in energies.items():
        if name != "idle" and not all(abs(a / b - 1) <= TOLERANCE for a, b in zip(own, energies["built-in"])):
            yield f"{name}: energies {own}, of the built-in one {energies['built-in']}"

    parts = {name: counts[name] - counts["idle"] for name in ("built-in", *MATERIALS) if name != "idle"}
    for name, part in parts.items():
        print(f"{name}: {part:.1f} of them in the material, {part / parts['by hand']:.2f} times those by hand")
    for what, ratio, limit in [("shape function", counts["spline"] / counts["built-in"], SHAPE_LIMIT),
                               ("material", parts["plain"] / parts["by hand"], MATERIAL_LIMIT)]:
        print(f"{what}: {ratio:.3f} times as many, at most {limit}")
        if not ratio <= limit:
            yield f"{what}: {ratio:.3f} times as many instructions, more than {limit}"

    library = sorted(plugins.glob(f"**/{MATERIALS['plain']}.so"))
    packed = packed_part(max(library, key=lambda file: instruction_set in file.parts))
    print(f"plain: {packed:.0%} of the arithmetic is packed")
    if not packed >= PACKED_PART:
        yield f"plain: {packed:.0%} of the arithmetic is packed, less than {PACKED_PART:.0%}: it is not vectorised"


def main(program):
    with tempfile.TemporaryDirectory() as folder:
        found = list(mistakes(Path(program), Path(folder)))
    print(*found, f"{len(found)} mistakes", sep="\n")
    return 1 if found else 0


sys.exit(main(sys.argv[1]))
