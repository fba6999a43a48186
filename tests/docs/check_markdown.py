#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Links, anchors and numbers of equations in the Markdown pages hold together, as GitHub shows them.

check_markdown.py             checks the repository
check_markdown.py --self-test the check finds the faults that it is for
"""

import re
import sys
import tempfile
from pathlib import Path

from markdown import ROOT, drop_code, find_anchors, find_links, find_pages


def check_links(page: Path, root: Path) -> list[str]:
    faults = []
    for line, target in find_links(page.read_text()):
        if re.match(r"[a-z]+:", target):
            continue
        name, _, anchor = target.partition("#")
        file = (page.parent / name).resolve() if name else page
        where = f"{page.relative_to(root)}:{line}: "
        if not file.exists():
            faults.append(f"{where}the link '{target}' leads to no file")
        elif anchor and file.suffix == ".md" and anchor not in find_anchors(file.read_text()):
            faults.append(f"{where}'{target}' names an anchor that {file.name} does not have")
    return faults


def check_equations(page: Path, root: Path) -> list[str]:
    """Every displayed equation of a theory page has the number of its page and place, its anchor before it, and every
    number in the text is a link to an equation."""
    text = page.read_text()
    name = str(page.relative_to(root))
    number = re.search(r"^# (\d+) ", text, flags=re.M)
    if not number:
        return [f"{name}: the heading of a theory page begins with its number"]
    faults = []
    formulas = list(re.finditer(r"^\$\$(.*?)\$\$", text, flags=re.S | re.M))
    for i, formula in enumerate(formulas, 1):
        line = text.count("\n", 0, formula.start()) + 1
        tags = re.findall(r"\\tag\{([^}]*)\}", formula[1])
        wanted = f"T{number[1]}.{i}"
        if tags != [wanted]:
            faults.append(f"{name}:{line}: this equation is ({wanted}), but says {tags or 'nothing'}")
        anchor = f'<a id="eq-{wanted.lower().replace(".", "-")}"></a>\n\n'
        if not text[: formula.start()].endswith(anchor):
            faults.append(f"{name}:{line}: '{anchor.strip()}' and an empty line must stand before ({wanted})")
    return faults


def check_references(page: Path, root: Path) -> list[str]:
    """[T2.3](...#eq-t2-3): text and target agree."""
    faults = []
    plain = drop_code(page.read_text())
    for found in re.finditer(r"\[(T\d+\.\d+)\]\(([^)]*)\)", plain):
        anchor = f"#eq-{found[1].lower().replace('.', '-')}"
        if not found[2].endswith(anchor):
            line = plain.count("\n", 0, found.start()) + 1
            faults.append(f"{page.relative_to(root)}:{line}: ({found[1]}) leads to '{found[2]}' and not to {anchor}")
    return faults


def check(root: Path) -> list[str]:
    faults = []
    for page in find_pages(root):
        faults += check_links(page, root) + check_references(page, root)
        if page.parent == root / "docs/theory":
            faults += check_equations(page, root)
    return faults


def test_itself() -> list[str]:
    """Each fault planted here must be found, and the sound page must pass."""
    sound = '# 1 A\n\n<a id="eq-t1-1"></a>\n\n$$a \\tag{T1.1}$$\n\n## B c!\n\n'
    sound += "[x](#b-c), ([T1.1](#eq-t1-1)), `[no](link)`\n"
    planted = {
        "leads to no file": sound + "[y](nowhere.md)\n",
        "names an anchor": sound + "[y](#nothing)\n",
        "but says ['T1.2']": sound.replace("tag{T1.1}", "tag{T1.2}"),
        "but says nothing": sound + '\n<a id="eq-t1-2"></a>\n\n$$b$$\n',
        "must stand before": sound.replace('<a id="eq-t1-1"></a>', '<a id="eq-t1-9"></a>'),
        "leads to '#b-c'": sound + "[T1.1](#b-c)\n",
        "begins with its number": sound.replace("# 1 A", "# A"),
    }
    missed = []
    for sentence, text in {"": sound, **planted}.items():
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            (root / "docs/theory").mkdir(parents=True)
            (root / "docs/theory/01-a.md").write_text(text)
            faults = check(root)
            if not sentence and faults:
                missed.append(f"finds faults in a sound page: {faults}")
            elif sentence and not any(sentence in fault for fault in faults):
                missed.append(f"does not find '{sentence}' but {faults}")
    return missed


if __name__ == "__main__":
    result = test_itself() if "--self-test" in sys.argv else check(ROOT)
    print("\n".join(result) or "links, anchors and equations hold together")
    sys.exit(bool(result))
