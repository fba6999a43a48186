#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Counts what the upper floors must not do: read results by string keys, look things up, include JSON in headers, search
our own sentences. Results are structs that describe themselves (src/results/); JSON is read and written there only.

Usage: check_results.py [root] [--counts] | check_results.py --self-test

Without --counts it exits with 1 and one line per fault. --counts prints the numbers only, for any state of the sources.
"""
import re
import sys
import tempfile
from pathlib import Path

# Floors that may use keys of JSON: results/ itself, and input/, whose echo and schema are JSON of the case and not of results.
MAY_READ = ("src/results/", "src/input/", "src/base/")
READS = [re.compile(p) for p in (
    r'\.at\("[A-Za-z_]+"\)', r'\.value\("[A-Za-z_]+",', r'\.(?:contains|erase)\("[A-Za-z_]+"\)',
    r'\["[A-Za-z_]+"\](?!\s*=(?!=))(?!\.push_back)(?!\.update)(?!\[)', r'\bfind(?:_list|_number)?\([^()]*\{"',
    r'\bget_(?:number|text|word|si|flag)\([^()]*"')]
# The page's contract is a document that report/ makes: what it put there under this name it may read again.
CONTRACT, DOCUMENT = "src/report/", re.compile(r'\b(?:document|section)(?:\[[^\]]*\])+')
# Words of others that the source searches for, with the reason.
MAY_SEARCH = {"src/output/plots/gnuplot.cpp": "what gnuplot says is no sentence of ours"}
WRITES = [re.compile(p) for p in (r'\{"[a-z_]+", ', r'\["[A-Za-z_]+"\]\s*=[^=]')]
HELPER = re.compile(r'^(?:const )?(?:nlohmann::)?(?:json|std::optional<double>|double|std::string|bool)[&*]? '
                    r'(?:find|get|list|find_list|find_number|get_number|get_text|get_si|get_word|get_flag|find_si|find_member)'
                    r'\((?:const )?(?:nlohmann::)?json')
INCLUDE = re.compile(r'#include <nlohmann/json\.hpp>')
# Our own words that the source searches for: .find("…"), starts_with("…") with a capital letter or a blank in it.
SEARCH = re.compile(r'(?:\.find|starts_with|ends_with)\(\s*"[^"]*(?:[A-Z]| )[^"]*"')
FOLDERS = {"analysis", "methods", "report", "export", "study", "laboratory", "app", "output", "run", "site"}


def strip_comments(text):
    return re.sub(r'R"\((.|\n)*?\)"|//[^\n]*', '', text)


def count(root):
    """{what: [place]} over src/."""
    found = {"reads": [], "writes": [], "helpers": [], "includes": [], "searches": []}
    for path in sorted((root / "src").rglob("*.[ch]pp")):
        name = path.relative_to(root).as_posix()
        if name.startswith(MAY_READ):
            if path.suffix == ".hpp" and name.startswith(("src/base/",)) and INCLUDE.search(path.read_text(encoding="utf-8")):
                found["includes"].append(name)
            continue
        upper = name.split("/")[1] in FOLDERS
        for number, line in enumerate(strip_comments(path.read_text(encoding="utf-8")).splitlines(), 1):
            place = f"{name}:{number}"
            if path.suffix == ".hpp" and INCLUDE.search(line):
                found["includes"].append(place)
            if not upper:
                continue
            asked = DOCUMENT.sub("document", line) if name.startswith(CONTRACT) else line
            found["reads"] += [place] * sum(len(p.findall(asked)) for p in READS)
            found["writes"] += [place] * sum(len(p.findall(line)) for p in WRITES)
            if HELPER.match(line):
                found["helpers"].append(place)
            if SEARCH.search(line) and name not in MAY_SEARCH:
                found["searches"].append(place)
    return found


def find_faults(root):
    found = count(root)
    words = {"reads": "reads a result by a string key; take it from its struct in src/results/",
             "helpers": "looks JSON up; take the struct", "includes": "a header includes json.hpp; json_fwd.hpp is enough",
             "searches": "searches a sentence of ours; let a struct or an enumerator carry what is asked"}
    return [f"{place}: {text}" for what, text in words.items() for place in dict.fromkeys(found[what])]


def run_self_test():
    tree = {
        "src/report/a.cpp": 'double f = summary.at("factor");\ndoc["written"] = 1;\nuse(document["written"]);\n'
                            'use(block["factor"]);\ntaken.erase("fits");\n',
        "src/study/a.cpp": 'auto x = summary["runout"]["toe"];\n',
        "src/report/b.hpp": "#include <nlohmann/json.hpp>\n",
        "src/run/c.cpp": 'if (text.starts_with("Finite elements, ")) return;\n',
        "src/results/d.cpp": 'object.at("free");\n',
    }
    expected = {"src/report/a.cpp:1", "src/report/a.cpp:4", "src/report/a.cpp:5", "src/study/a.cpp:1", "src/report/b.hpp:1",
                "src/run/c.cpp:1"}
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for name, text in tree.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text, encoding="utf-8")
        places = {fault.split(": ")[0] for fault in find_faults(root)}
    return [f"self-test: {sorted(places)} instead of {sorted(expected)}"] if places != expected else []


def main():
    arguments = sys.argv[1:]
    named = [a for a in arguments if not a.startswith("--")]
    root = Path(named[0]) if named else Path(__file__).resolve().parent.parent
    if "--counts" in arguments:
        for what, places in count(root).items():
            print(f"{what}: {len(places)}")
        return 0
    faults = run_self_test() if "--self-test" in arguments else find_faults(root)
    print("\n".join(faults) if faults else "check_results: results are structs.")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
