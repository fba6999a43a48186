# SPDX-License-Identifier: MIT
"""Reads Markdown as GitHub does: its links, its anchors, its blocks of code, its equations."""

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def find_pages(root: Path = ROOT) -> list[Path]:
    """Every page that a reader of the repository sees."""
    pages = [*root.glob("*.md"), *(root / "examples").rglob("*.md"), *(root / "docs").rglob("*.md")]
    return sorted(page for page in pages if "node_modules" not in page.parts)


def drop_code(text: str) -> str:
    """Blanks out code, where no link and no formula is one; lines keep their numbers."""
    text = re.sub(r"^( *)(```+)[^\n]*\n.*?^ *\2[ ]*$", lambda m: "\n" * m[0].count("\n"), text, flags=re.S | re.M)
    return re.sub(r"(`+)(?!`).+?(?<!`)\1(?!`)", "", text)


def find_links(text: str) -> list[tuple[int, str]]:
    """(line, target) of every link and picture."""
    plain = drop_code(text)
    return [(plain.count("\n", 0, m.start()) + 1, m[1]) for m in re.finditer(r"\]\(([^()\s]+(?:\([^()]*\))?)\)", plain)]


def make_slug(heading: str) -> str:
    """GitHub's anchor of a heading."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading.strip()).replace("`", "")
    return re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-")


def find_anchors(text: str) -> set[str]:
    """Anchors of headings (a second one of the same name gets -1) and those set by hand."""
    plain = re.sub(r"^( *)(```+)[^\n]*\n.*?^ *\2[ ]*$", "", text, flags=re.S | re.M)
    anchors: set[str] = set(re.findall(r'<a id="([^"]+)"', plain))
    seen: dict[str, int] = {}
    for heading in re.findall(r"^#{1,6} (.+)$", plain, flags=re.M):
        slug = make_slug(heading)
        count = seen.get(slug, 0)
        seen[slug] = count + 1
        anchors.add(f"{slug}-{count}" if count else slug)
    return anchors
