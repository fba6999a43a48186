#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes docs/where-is.md, one line a file: the first sentence of each source file, by floor and room. A header and a source of
one name are one row, with what the header says.

Usage: where_is.py | where_is.py --check | where_is.py --self-test     --check only says whether the page is of today.
"""
import re
import sys
import tempfile
from pathlib import Path

from check_floors import ALLOWED

ROOT = Path(__file__).resolve().parent.parent
PAGE = "docs/where-is.md"
INTRO = """# Where is …

Every source file with the first sentence of its first comment, by floors and rooms ([architecture](architecture.md)). A name
without an ending is a header and its source. Tests lie by the kind of truth that they use ([contributing](../CONTRIBUTING.md)).

Search it for a word. It is made by `tools/where_is.py`, which `make format` calls: to change a line, change the comment.
"""
# Folder and endings of its files, in the order of the page; floors from the command down to the ground.
PLACES = [*((f"src/{floor}", (".hpp", ".cpp")) for floor in reversed(ALLOWED)), ("web/src", (".ts", ".tsx", ".css")),
          ("python", (".py", ".cpp", ".hpp")), ("docs/site", (".js",)), ("tools", (".py", ".sh")), ("cmake", (".cmake",)),
          ("bench", (".hpp", ".cpp", ".py"))]
NOT_SHOWN = {"node_modules", "__pycache__", "tests", "assets", "layouts"}
# Neither a first comment nor a part of it.
BEFORE = re.compile(r"\s*$|#!|#pragma once|(?://|#|/\*|\"\"\")\s*SPDX-License-Identifier")


def find_sentence(text):
    """The first sentence of the first comment; empty where the code comes first."""
    lines = text.splitlines()
    while lines and BEFORE.match(lines[0]):
        lines.pop(0)
    rest = "\n".join(lines)
    if block := re.match(r'(?:"""|/\*+)(.*?)(?:"""|\*/)', rest, flags=re.S):
        lines = block[1].splitlines()
    else:
        lines = (re.match(r"(?:(?:// ?|# )[^\n]*(?:\n|$))*", rest)[0]).splitlines()
    paragraph = []
    for line in lines:
        words = re.sub(r"^\s*(?://|#|\*)?\s*", "", line).strip()
        if words:
            paragraph.append(words)
        elif paragraph:
            break
    return re.match(r".*?(?<!e\.g)(?<!et al)(?<!\.)\.(?= |$)|.*", " ".join(paragraph))[0]


def list_rows(root, folder, endings):
    """{room: {name: sentence}} of a folder."""
    rooms = {}
    for path in sorted((root / folder).rglob("*"), key=lambda path: (path.parent, path.stem, path.suffix != ".hpp")):
        # What was installed beside the sources holds folders with the names of files.
        if path.suffix not in endings or ".test." in path.name or NOT_SHOWN & set(path.relative_to(root).parts) or not path.is_file():
            continue
        text = path.read_text(encoding="utf-8")
        if not text:
            continue
        room = rooms.setdefault(path.parent.relative_to(root).as_posix(), {})
        sentence = find_sentence(text)
        if path.suffix == ".cpp" and path.stem + ".hpp" in room:
            room[path.stem] = room.pop(path.stem + ".hpp") or sentence
        else:
            room[path.name] = sentence
    return rooms


def write_page(root):
    """(text, faults)"""
    text, faults = INTRO, []
    for folder, endings in PLACES:
        for room, rows in list_rows(root, folder, endings).items():
            text += f"\n## {room}/\n\n| | |\n|---|---|\n"
            for name, sentence in sorted(rows.items()):
                text += f"| `{name}` | " + re.sub(r"([|<*])", r"\\\1", sentence) + " |\n"
                if not sentence:
                    faults.append(f"{room}/{name}: no comment at its head says what it is")
    return text, faults


def find_faults(root, check):
    text, faults = write_page(root)
    page = root / PAGE
    if not check:
        page.write_text(text, encoding="utf-8")
    elif not page.exists() or page.read_text(encoding="utf-8") != text:
        faults.append(f"{PAGE} is not of today: tools/where_is.py makes it anew")
    return faults


def run_self_test():
    """The sentence is found behind what may stand before it; a page of yesterday and a file without a comment are faults."""
    licence = "// SPDX-License-Identifier: MIT\n"
    tree = {
        "src/base/pair.hpp": licence + "#pragma once\n// Two of a\n// kind, e.g. x. More of it.\n\n// And more.\n",
        "src/base/pair.cpp": "// How.\n",
        "src/base/single.cpp": "// Alone\n//\n// in the room\n",
        "tools/draw.py": '#!/usr/bin/env python3\n# SPDX-License-Identifier: MIT\n"""Draws [x]. Twice."""\n',
        "web/src/look.css": "/* Colours\n * of things. */\n",
        "docs/site/node_modules/punycode.js/index.js": "/* Installed. */\n",
    }
    expected = ["| `pair` | Two of a kind, e.g. x. |", "| `single.cpp` | Alone |", "| `draw.py` | Draws [x]. |",
                "| `look.css` | Colours of things. |"]
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for name, text in {**tree, "docs/x.md": ""}.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text, encoding="utf-8")
        lost = [row for row in expected if row not in write_page(root)[0].splitlines()]
        faults = [f"self-test: '{row}' is not on the page" for row in lost]
        faults += find_faults(root, check=False) + find_faults(root, check=True)
        (root / "src/base/pair.hpp").write_text("#pragma once\n#include <x>\n// Late.\n")
        (root / "src/base/pair.cpp").write_text("int i;\n")
        found = find_faults(root, check=True)
    return faults if len(found) == 2 else [*faults, f"self-test: two faults were planted, and {found} found"]


def main():
    arguments = sys.argv[1:]
    faults = run_self_test() if arguments == ["--self-test"] else find_faults(ROOT, check=arguments == ["--check"])
    print("\n".join(faults) if faults else f"where_is: {PAGE} is of today.")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
