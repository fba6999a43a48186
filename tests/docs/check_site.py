#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The built manual is whole: check_site.py PROGRAM SITE.

Every link and anchor leads somewhere, nothing is loaded from elsewhere, ids are unique, every key of `talus schema` and
every command has its place in the reference, every formula of the theory was set, and the site stays small.
"""

import json
import re
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote

PROGRAM, SITE = sys.argv[1], Path(sys.argv[2]).resolve()
LOADS = {("script", "src"), ("link", "href"), ("img", "src"), ("iframe", "src"), ("source", "src"), ("object", "data")}
LARGEST_SITE = 12e6  # bytes, of 234 pages, 47 kB each; three in the theory alone, most of it formulas that are drawn without a network


class Page(HTMLParser):
    """Links, loaded files and ids of a page."""

    def __init__(self, path: Path):
        super().__init__()
        self.path, self.links, self.loads, self.ids = path, [], [], []
        self.feed(path.read_text())

    def handle_starttag(self, tag, attrs):
        for name, value in attrs:
            if name == "id":
                self.ids.append(value)
            elif (tag, name) in LOADS:
                self.loads.append(value)
            elif tag == "a" and name == "href":
                self.links.append(value)


def find_faults(pages: dict[Path, Page]) -> list[str]:
    faults = []
    for path, page in pages.items():
        name = path.relative_to(SITE)
        doubles = {value for value in page.ids if page.ids.count(value) > 1}
        faults += [f"{name}: the id '{value}' stands more than once" for value in sorted(doubles)]
        for target in page.loads:
            if not target.startswith("data:") and not (path.parent / target).is_file():
                faults.append(f"{name}: loads '{target}', which is not in the site")
        for target in page.links:
            if re.match(r"(https?|mailto):", target):
                continue
            file, _, anchor = unquote(target).partition("#")
            to = (path.parent / file).resolve() if file else path
            if not to.is_file():
                faults.append(f"{name}: the link '{target}' leads to no file")
            elif anchor and to in pages and anchor not in pages[to].ids:
                faults.append(f"{name}: the link '{target}' leads to no anchor")
    for sheet in SITE.rglob("*.css"):
        for target in re.findall(r"url\(([^)]*)\)", sheet.read_text()):
            if not (sheet.parent / target.strip("\"'")).is_file():
                faults.append(f"{sheet.name}: loads '{target}', which is not in the site")
    return faults


def list_keys(schema: dict, path: str = "") -> list[str]:
    """Paths of all keys of a JSON Schema; a table under a free name is NAME."""
    schema = schema.get("items", schema) if isinstance(schema.get("items"), dict) else schema
    inner = dict(schema.get("properties", {}))
    if isinstance(schema.get("additionalProperties"), dict):
        inner["NAME"] = schema["additionalProperties"]
    if path and not inner:
        return [path]
    return [key for name, part in inner.items() for key in list_keys(part, f"{path}.{name}" if path else name)]


def run(*words: str) -> str:
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True, check=True).stdout


def check_reference(pages: dict[Path, Page]) -> list[str]:
    ids = {value for path, page in pages.items() if path.parent.name == "reference" for value in page.ids}
    keys = list_keys(json.loads(run("schema")))
    faults = [] if len(keys) > 80 else [f"the schema has {len(keys)} keys only: {keys}"]
    faults += [f"the key '{key}' has no anchor in the reference" for key in keys if key not in ids]
    commands = re.findall(r"^ {2}(\w+) ", run("--help").split("Subcommands:")[1], flags=re.M)
    return faults + [f"the command '{name}' is not in the reference" for name in commands if f"talus-{name}" not in ids]


def check_formulas(pages: dict[Path, Page]) -> list[str]:
    """As many numbered equations as tags in the Markdown, and no TeX left over in the text."""
    source = Path(__file__).resolve().parents[2] / "docs"
    faults = []
    for markdown in source.glob("theory/*.md"):
        html = SITE / "theory" / f"{markdown.stem}.html"
        tags = len(re.findall(r"\\tag\{", markdown.read_text()))
        made = len([value for value in pages[html].ids if value.startswith("eq-")])
        if tags != made or not tags:
            faults.append(f"{html.name}: {made} equations of {tags}")
    for path in pages:
        text = re.sub(r"<(code|pre|annotation|script)\b.*?</\1>", "", path.read_text(), flags=re.S)
        found = re.search(r"\$[^$<>]*\\[a-z]+[^$<>]*\$", text)
        if found:
            faults.append(f"{path.relative_to(SITE)}: a formula was not set: {found[0]}")
    return faults


if __name__ == "__main__":
    pages = {path: Page(path) for path in sorted(SITE.rglob("*.html"))}
    size = sum(file.stat().st_size for file in SITE.rglob("*") if file.is_file())
    faults = find_faults(pages) + check_reference(pages) + check_formulas(pages)
    if size > LARGEST_SITE:
        faults.append(f"the site has {size / 1e6:.1f} MB; at most {LARGEST_SITE / 1e6:.0f} are wanted")
    print("\n".join(faults) or f"{len(pages)} pages, {size / 1e6:.1f} MB, whole")
    sys.exit(bool(faults))
