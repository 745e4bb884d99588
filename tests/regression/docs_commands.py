#!/usr/bin/env python3
"""Runs the commands of the documentation.

usage: docs_commands.py ROOT PREFIX [FILE]...    (the source tree; an installation; which files, all by default)

The ```sh blocks of a file run one after the other in one folder, a copy of the scenes, with PREFIX/bin on the PATH. What stands
in an HTML comment before a block changes that:
  <!-- run by: apps/check -->          the block is not run, because this script runs it
  <!-- ends with: 2 -->                its exit status
  <!-- same as: path/to/file -->       the block is that file's text (also for other languages)
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

BLOCK = re.compile(r"(?:^<!-- (run by|ends with|same as): ([^\n]*?) -->\n)?^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
PAGES = ["README.md", "framework/README.md", "configs/tutorials/README.md", "framework/docs/**/*.md"]


def run(block, folder, prefix):
    paths = {"PATH": f"{prefix}/bin:{os.environ['PATH']}"}
    environment = {k: v for k, v in os.environ.items() if k not in ("MATPOINT_PLUGIN_PATH", "LD_LIBRARY_PATH")} | paths
    return subprocess.run(["bash", "-euo", "pipefail", "-c", block], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def check(root, prefix, file):
    mistakes, count = [], 0
    with tempfile.TemporaryDirectory() as folder:
        for part in ("configs", "plugins"):
            shutil.copytree(root / part, Path(folder) / part)
        for match in BLOCK.finditer((root / file).read_text()):
            mark, value, language, block = match.groups()
            line = (root / file).read_text().count("\n", 0, match.start(3)) + 1
            if mark == "same as":
                if (root / value).read_text() != block:
                    mistakes.append(f"{file}:{line}: is not {value}")
            elif mark == "run by":
                if not (root / value).is_file():
                    mistakes.append(f"{file}:{line}: there is no {value}")
            elif language == "sh":
                count += 1
                done = run(block, folder, prefix)
                if done.returncode != int(value or 0):
                    mistakes.append(f"{file}:{line}: status {done.returncode}\n{block}{done.stdout}")
    print(f"{file}: {count} blocks run")
    return mistakes


def main(root, prefix, *files):
    root, prefix = Path(root).resolve(), Path(prefix).resolve()
    files = files or [f.relative_to(root) for page in PAGES for f in sorted(root.glob(page))]
    mistakes = [mistake for file in files for mistake in check(root, prefix, file)]
    print(*mistakes, sep="\n")
    return 1 if mistakes else 0


sys.exit(main(*sys.argv[1:]))
