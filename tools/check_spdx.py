#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every source file says its licence in its first line (after #!), as https://spdx.dev asks: SPDX-License-Identifier, and the
name of the licence in LICENSE. Exits with 1 and one line per file that does not.

Usage: check_spdx.py | check_spdx.py --write | check_spdx.py --self-test     --write puts the line where it is missing.
"""
import re
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
# First line of LICENSE → its name at SPDX.
LICENCES = {"MIT License": "MIT"}
MARKS = {
    "// {}": ".cpp .hpp .c .cu .ts .tsx .js .mjs",
    "# {}": ".py .pyi .sh .cmake CMakeLists.txt Makefile run",
    "/* {} */": ".css",
    "! {}": ".f .f90",
}
MARK_OF = {ending: mark for mark, endings in MARKS.items() for ending in endings.split()}
NOT_OURS = {".git", "build", "results", "shared"}


def list_sources(root):
    """(path, the form of a comment) of every file that must have the line; an empty file holds nothing to license."""
    for path in sorted(root.rglob("*")):
        parts = path.relative_to(root).parts
        mark = MARK_OF.get(path.name) or MARK_OF.get(path.suffix)
        if mark and parts[0] not in NOT_OURS and "node_modules" not in parts and path.is_file() and path.stat().st_size:
            yield path, mark


def find_faults(root, write=False):
    faults = []
    title = (root / "LICENSE").read_text(encoding="utf-8").splitlines()[0].strip()
    for path, mark in list_sources(root):
        wanted = mark.format(f"SPDX-License-Identifier: {LICENCES[title]}")
        lines = path.read_text(encoding="utf-8").splitlines(keepends=True)
        place = 1 if lines[0].startswith("#!") else 0
        if len(lines) > place and lines[place].rstrip() == wanted:
            continue
        named = re.search(r"SPDX-License-Identifier: (?:\S+ (?:AND|OR|WITH) )*\S+", "".join(lines[:5]))
        if write and not named:
            lines.insert(place, wanted + "\n")
            path.write_text("".join(lines), encoding="utf-8")
        else:
            found = f", and not '{named[0]}' elsewhere" if named else ""
            faults.append(f"{path.relative_to(root).as_posix()}:{place + 1}: must be '{wanted}'{found}")
    return faults


def run_self_test():
    """A missing line is found and written once, behind #!; another licence is found and left to a person."""
    tree = {
        "LICENSE": "MIT License\n",
        "src/a.hpp": "#pragma once\n",
        "src/b.cpp": "// SPDX-License-Identifier: MIT\nint b;\n",
        "tools/c.py": '#!/usr/bin/env python3\n"""C."""\n',
        "tools/__init__.py": "",
        "web/d.css": "a {}\n",
        "web/e.ts": "// SPDX-License-Identifier: GPL-3.0-only\n",
        "web/node_modules/f.js": "f;\n",
        "CMakeLists.txt": "project(x)\n",
    }
    missing = ["CMakeLists.txt:1", "src/a.hpp:1", "tools/c.py:2", "web/d.css:1"]
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for name, text in tree.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text, encoding="utf-8")
        runs = [[fault.split(": ")[0] for fault in find_faults(root, write)] for write in (False, True, False)]
        script = (root / "tools/c.py").read_text(encoding="utf-8").splitlines()
    expected = [[*missing, "web/e.ts:1"], ["web/e.ts:1"], ["web/e.ts:1"]]
    faults = [f"self-test: {found} instead of {wanted}" for found, wanted in zip(runs, expected) if found != wanted]
    if script[1:] != ["# SPDX-License-Identifier: MIT", '"""C."""']:
        faults.append(f"self-test: the line stands wrongly in {script}")
    return faults


def main():
    arguments = sys.argv[1:]
    faults = run_self_test() if arguments == ["--self-test"] else find_faults(ROOT, write=arguments == ["--write"])
    print("\n".join(faults) if faults else "check_spdx: every source names its licence.")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
