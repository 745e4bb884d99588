#!/usr/bin/env python3
"""layers.py ROOT: every #include of the SDK, kernel, plugins and apps is one that framework/layers.txt allows."""

import re
import sys
from pathlib import Path

INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]', re.MULTILINE)
KERNEL = "framework/src"


def read_layers(root):
    """Allowed beginnings by part. A part that is named as a beginning must be listed before."""
    layers = {}
    for line in (root / "framework/layers.txt").read_text().splitlines():
        if not line.strip() or line.startswith("#"):
            continue
        part, _, allowed = line.partition(":")
        layers[part] = allowed.split()
        for beginning in layers[part]:
            other = beginning.rstrip("/")
            if (root / KERNEL / other).is_dir() and other not in layers:
                yield f"framework/layers.txt: {part} may not include {other}, which is not listed above it"
    yield layers


def folders(root):
    """The folders of source files and the part each belongs to."""
    yield root / "framework/include/matpoint", "sdk"
    yield root / "plugins", "plugins"
    for folder in sorted((root / KERNEL).iterdir()):
        yield folder, folder.name
    for folder in sorted((root / "apps").iterdir()):
        if folder.is_dir():
            yield folder, f"apps/{folder.name}"


def is_standard(kind, path):
    return kind == "<" and re.fullmatch(r"[a-z_0-9]+", path) is not None


def is_own(part, file, path):
    """A header beside the file or, for plugins, in the folder of their kind; in the kernel, <part>/..."""
    header = (file.parent / path).resolve()
    if part == "plugins":
        return header.is_file() and header.parent in (file.parent, file.parent.parent)
    if part == "sdk" or part.startswith("apps/"):
        return header.is_file() and header.parent == file.parent
    return path.startswith(f"{part}/")


def main(root):
    *mistakes, layers = read_layers(root)
    files = 0
    for folder, part in folders(root):
        if part not in layers:
            mistakes.append(f"{folder.relative_to(root)}: not listed in framework/layers.txt")
            continue
        for file in sorted([*folder.rglob("*.cpp"), *folder.rglob("*.hpp")]):
            files += 1
            for kind, path in INCLUDE.findall(file.read_text()):
                if (is_standard(kind, path) or path.startswith(("matpoint/", *layers[part]))
                        or is_own(part, file, path)):
                    continue
                mistakes.append(f"{file.relative_to(root)}: may not include {path}")
    print(*mistakes, f"{files} files, {len(mistakes)} mistakes", sep="\n")
    return 1 if mistakes or not files else 0


sys.exit(main(Path(sys.argv[1]).resolve()))
