#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that no function of src/ is longer than 80 lines or has more than seven parameters without a reason written
beside it: "// long: why" or "// many: why" above the function. Exits with 1 and one line per fault.

Usage: check_functions.py [root] | check_functions.py --self-test | check_functions.py --list
"""
import re
import sys
import tempfile
from pathlib import Path

LONGEST = 80
MOST = 7
# What may stand between the parameters of a function and its body.
TAIL = r"(?:\s*(?:const|noexcept|override|final|mutable|->[\w\s:<>,*&]+))*\s*"
BLANKED = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])+\'|'
                     r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.S | re.M)


def blank(text):
    """The text without comments, strings and directives, of the same length and with the same lines."""
    return BLANKED.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), text)


def find_end(text, start, pair):
    """The place behind the bracket that closes the one at `start`."""
    depth = 0
    for place in range(start, len(text)):
        depth += (text[place] == pair[0]) - (text[place] == pair[1])
        if depth == 0:
            return place + 1
    return len(text)


def count_parameters(text):
    """Commas outside of all brackets, and one; a comparison cannot stand there without brackets."""
    depth, commas = 0, 0
    for c in text.replace("->", "  "):
        depth += (c in "(<[{") - (c in ")>]}")
        commas += c == "," and depth == 0
    return commas + 1 if text.strip() else 0


def read_head(head):
    """(name, parameters) of the function that a body follows; None when it is no function's."""
    for found in re.finditer(r"((?:\boperator\s*[^\s\w(]+)|\boperator\(\)|~?\b\w+)\s*\(", head):
        end = find_end(head, found.end() - 1, "()")
        if found[1] in ("if", "for", "while", "switch", "decltype", "requires", "noexcept", "__attribute__", "alignas"):
            continue
        if re.fullmatch(TAIL + r"(?::(?!:).*)?", head[end:], re.S):
            return found[1], count_parameters(head[found.end():end - 1])
    return None


def list_functions(text):
    """(name, parameters, first line, last line) of every function with a body."""
    code = blank(text)
    start = place = 0
    while place < len(code):
        c = code[place]
        if c == "(":
            place = find_end(code, place, "()")
            continue
        if c in ";}":
            start = place + 1
        elif c == "{":
            head = code[start:place]
            function = None if re.search(r"\b(namespace|enum)\b", head) else read_head(head)
            if function:
                end = find_end(code, place, "{}")
                if re.search(r"\)\s*:(?!:)", head) and re.search(r"\w\s*$", head):  # a member's initial value
                    place = end
                    continue
                first = start + len(head) - len(head.lstrip())
                template = re.match(r"template\s*(?=<)", code[first:])
                if template:  # the line of a template's parameters is none of the function's
                    after = find_end(code, first + template.end(), "<>")
                    first = after + len(code[after:]) - len(code[after:].lstrip())
                yield *function, code.count("\n", 0, first) + 1, code.count("\n", 0, end) + 1
                start = place = end
                continue
            if "=" not in head or re.search(r"\b(struct|class)\b", head):
                start = place + 1
            else:
                place = find_end(code, place, "{}")
                continue
        place += 1


def read_reasons(lines, first):
    """The kinds of reasons in the comments above line `first`, and behind a template's parameters there."""
    kinds = set()
    for line in reversed(lines[:first - 1]):
        if not re.match(r"\s*(//|template\b|requires\b)", line):
            break
        kinds.update(re.findall(r"// (long|many): .", line))
    return kinds


def find_faults(root):
    for path in sorted((root / "src").rglob("*.[ch]pp")):
        text = path.read_text(encoding="utf-8")
        lines = text.splitlines()
        for name, parameters, first, last in list_functions(text):
            place, length, reasons = f"{path.relative_to(root).as_posix()}:{first}", last - first + 1, read_reasons(lines, first)
            for kind, value, most, what in (("long", length, LONGEST, "lines"), ("many", parameters, MOST, "parameters")):
                if value > most and kind not in reasons:
                    yield f'{place}: {name} has {value} {what}; over {most} it needs a reason, "// {kind}: …" above it'
                if value <= most and kind in reasons:
                    yield f'{place}: {name} has {value} {what} and needs no "// {kind}: …"'


def run_self_test():
    """Every rule must be able to fail: functions with one fault of each kind among such as have none."""
    body = "  f({1, 2});\n" * (LONGEST - 2)
    text = ("namespace a {\nstruct S {\n  S(int x) : x_{x}, y_(x) {}\n  int x_ = 0, y_{1};\n};\n"
            f"void f() {{\n{body}}}\n"
            "template <class T, int N>\nT fit(int a, std::map<int, T> b, int c, int d, int e, int f, T (*g)(int, int)) {}\n"
            f"// long: the test says so\nint g() {{\n{body}\n\n}}\n"
            f"/// Wrong.\ntemplate <class T>\nauto too_long() -> T {{\n{body}\n\n}}\n"
            "const auto table = {1, 2};\n"
            "inline bool operator<(S, S) { return '}' == \"{\"[0]; }  // {\n"
            "// many: the test says so\nvoid h(int, int, int, int, int, int, int, int) {}\n"
            "int too_many(int a, int b, int c, int d, int e, int f, int g, int h = 1) {\n  return [] { return 1; }();\n}\n"
            "// long: it is not\nvoid not_long() {}\n}\n")
    expected = ["too_long", "too_many", "not_long"]
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "src").mkdir()
        (Path(folder) / "src" / "file.cpp").write_text(text, encoding="utf-8")
        faults = list(find_faults(Path(folder)))
    seen = [fault.split()[1] for fault in faults]
    return [] if seen == expected else [f"self-test: {expected} expected, found {faults}"]


def list_all(root):
    for path in sorted((root / "src").rglob("*.[ch]pp")):
        for name, parameters, first, last in list_functions(path.read_text(encoding="utf-8")):
            yield f"{last - first + 1}\t{parameters}\t{path.relative_to(root).as_posix()}:{first}\t{name}"


def main():
    arguments = sys.argv[1:]
    root = Path(arguments[0]) if arguments and not arguments[0].startswith("-") else Path(__file__).resolve().parent.parent
    if arguments == ["--list"]:
        print("\n".join(list_all(root)))
        return 0
    faults = run_self_test() if arguments == ["--self-test"] else list(find_faults(root))
    print("\n".join(faults) if faults else "check_functions: none is too long, none has too many parameters.")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
