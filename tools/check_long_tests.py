#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every name in tests/long_tests.txt is a test, and every long test names a test of `make test` that does the same kind of check.

Usage: check_long_tests.py BUILD_FOLDER
"""
import json
import pathlib
import subprocess
import sys
import tempfile

LIST = pathlib.Path(__file__).resolve().parent.parent / "tests/long_tests.txt"


def list_tests(build):
    """In a folder of its own: a list replaces the log of the tests that run."""
    with tempfile.TemporaryDirectory() as scratch:
        (pathlib.Path(scratch) / "CTestTestfile.cmake").write_text(f'subdirs("{pathlib.Path(build).resolve()}")\n')
        done = subprocess.run(["ctest", "--test-dir", scratch, "--show-only=json-v1"], capture_output=True, text=True, check=True)
    return {test["name"] for test in json.loads(done.stdout)["tests"]}


def find_faults(text, tests):
    rows = [(number, line.split("#")[0].split()) for number, line in enumerate(text.splitlines(), 1)]
    rows = [(number, words) for number, words in rows if words]
    long = [words[0] for _, words in rows]
    for number, words in rows:
        place = f"tests/long_tests.txt:{number}"
        if len(words) != 2:
            yield f"{place}: a line names a long test and the test of its kind that stays in make test"
            continue
        name, kept = words
        if long.count(name) > 1:
            yield f"{place}: {name} stands here twice"
        for word in words:
            if word not in tests:
                yield f"{place}: there is no test {word}"
        if kept in long:
            yield f"{place}: {kept} is to stay in make test, and is long itself"
        if kept.split(".")[0] != name.split(".")[0]:
            yield f"{place}: {kept} is of another group than {name}"


def test_itself():
    tests = {"a.One", "a.Two", "b.Three"}
    for text, wanted in (("# none\n\na.One a.Two # a reason\n", 0), ("a.One\n", 1), ("a.Gone a.Two\n", 1), ("a.One a.Gone\n", 1), ("a.One b.Three\n", 1),
                         ("a.One a.Two\na.One a.Two\n", 2), ("a.One a.Two\na.Two a.One\n", 2)):
        found = list(find_faults(text, tests))
        if len(found) != wanted:
            raise SystemExit(f"{text!r}: {found}")


if __name__ == "__main__":
    test_itself()
    faults = list(find_faults(LIST.read_text(encoding="utf-8"), list_tests(sys.argv[1])))
    print("\n".join(faults) if faults else "every name is a test")
    sys.exit(1 if faults else 0)
