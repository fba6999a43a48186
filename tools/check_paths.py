#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that names of cases, jobs and results become paths in one place only, base/user_file, that files are opened in
one place only for each purpose, that what is printed goes through print() of base/text, and that nothing depends
on the locale: a name may hold ".." or an escape sequence, a file may be a pipe or a link to another one, and a locale may
have a decimal comma.

Usage: check_paths.py [root] | check_paths.py --self-test
"""
import re
import sys
import tempfile
from pathlib import Path

# A member of a struct that holds a name of a case, a list of jobs or a result, or a text that came in a message.
NAMED = re.compile(r'(?<![/*])/=?\s*\(?[\w.\->()\[\]*]*(?:[.>](?:name|title|label|folder|file|picture|\w+_file)\b(?!\()|get_text\(\))')
# Reads of members that only the program itself fills, with the reason.
MAY_NAME = {
    "src/app/launch/launch.cpp": "levels that the program itself lists",
    "src/input/case/calibration.cpp": "a case reads files wherever they are",
    "src/input/case/layers.cpp": "a case reads files wherever they are",
    "src/input/case/pressure_table.cpp": "a case reads files wherever they are",
    "src/input/case/series_file.cpp": "a case reads files wherever they are",
}
OPENS = re.compile(r'\b(?:std::)?(?:ifstream|ofstream|fstream|fopen)\b(?!>)|(?<![\w.>])::open\(|\bdlopen\(|\bH5F(?:open|create)\(|'
                   r'\bgmsh::(?:open|merge)\(')
# Files that may open others, with the reason.
MAY_OPEN = {
    "src/base/user_file.cpp": "regular files that a user names",
    "src/base/atomic_file.cpp": "new files under their temporary names",
    "src/base/file_list.cpp": "the list of a folder, which no link may stand for",
    "src/base/file_list.cpp": "files of a list, which are regular",
    "src/base/folder_lock.cpp": "the lock of a folder",
    "src/base/foreign_code.cpp": "/dev/null",
    "src/base/memory.cpp": "what the system says of its memory",
    "src/studio/process.cpp": "the state of a process in /proc, and the end of a growing log that is no link",
    "src/base/foreign_code.cpp": "the program's own modules",
    "src/output/files/history.cpp": "rows at the end of a history that it has begun",
    "src/laboratory/evaluation_store.cpp": "lines at the end of evaluations that it has begun",
    "src/output/files/hdf5.cpp": "results in HDF5, after find_file_fault()",
    "src/mesh/check_mesh_file.cpp": "a mesh line by line, after find_file_fault()",
    "src/gmsh/mesh_of_file.cpp": "a mesh by Gmsh, after check_mesh_file()",
    "src/material/external.cpp": "a compiled soil, after find_file_fault()",
}

PRINTS = re.compile(r'\bfmt::print\(|\bstd::(?:fputs|puts|printf|fprintf|fwrite|cout|cerr)\b')
# Files that may print otherwise, with the reason.
# The C library of WebAssembly knows one locale, with a decimal point.
MAY_BE_LOCAL = {"src/base/numbers.cpp"}
MAY_PRINT = {
    "src/base/text.cpp": "print() itself",
    "src/base/progress.cpp": "the codes that clear a line",
    "src/app/command_line.cpp": "texts of the program alone",
    "src/app/launch/launch.cpp": "before the program is chosen",
    "src/app/commands.cpp": "texts of the program alone",
    "src/app/commands.cpp": "texts of the program alone",
    "src/app/commands.cpp": "texts of the program alone",
    "src/app/commands.cpp": "texts of the program alone",
    "src/laboratory/evaluation_store.cpp": "numbers, into a file that it has begun",
    "src/output/plots/gnuplot.cpp": "a script, into a temporary file",
}

# "7.25" is 7 where the locale has a decimal comma, and Turkish has no i for I.
LOCAL = re.compile(r'\b(?:strto(?:d|f|ld)|ato[fl]|sto(?:d|f|ld)|tolower|toupper)\(')


def find_faults(root):
    faults = []
    for path in sorted((root / "src").rglob("*.[ch]pp")):
        name = path.relative_to(root).as_posix()
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            code = re.sub(r'"(?:[^"\\]|\\.)*"', '""', line.split("//")[0])
            if code.lstrip().startswith("#"):
                continue
            if NAMED.search(code) and name not in MAY_NAME:
                faults.append(f"{name}:{number}: a name becomes a path; use join_name() of base/user_file.hpp")
            if OPENS.search(code) and name not in MAY_OPEN:
                faults.append(f"{name}:{number}: opens a file; use base/user_file.hpp or base/atomic_file.hpp")
            if PRINTS.search(code) and name not in MAY_PRINT:
                faults.append(f"{name}:{number}: prints what may hold names; use print() of base/text.hpp")
            if LOCAL.search(code) and name not in MAY_BE_LOCAL:
                faults.append(f"{name}:{number}: depends on the locale; use read_number() of base/numbers.hpp, or to_lower() of base/text.hpp")
    return faults


def run_self_test():
    tree = {
        "src/study/a.cpp": 'auto p = options.folder / variant.name;\nauto q = folder / "study.json";\np /= told.folder;\n'
                           'auto r = folder / (line.name + ".csv");\nauto s = folder / message.get_text();\n'
                           'auto t = join_name(folder, v.name);\nauto u = length / unit.si;\n',
        "src/input/b.cpp": 'std::ifstream file(path);\nconst int f = ::open(path.c_str(), 0);\nhistory.open();\n',
        "src/app/c.cpp": 'fmt::print("{}", run.title);\nprint(stdout, run.title);\nstd::fputs(x, stderr);\n',
        "src/site/d.cpp": 'const double x = std::strtod(text.c_str(), nullptr);\nconst double y = read_number(text);\nc = std::tolower(c);\n',
        "src/base/user_file.cpp": 'file_ = ::open(path.c_str(), O_RDONLY);\n',
    }
    expected = {"src/study/a.cpp:1", "src/study/a.cpp:3", "src/study/a.cpp:4", "src/study/a.cpp:5", "src/input/b.cpp:1",
                "src/input/b.cpp:2", "src/app/c.cpp:1", "src/app/c.cpp:3", "src/site/d.cpp:1", "src/site/d.cpp:3"}
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
    faults = run_self_test() if "--self-test" in arguments else find_faults(root)
    print("\n".join(faults) if faults else "check_paths: names become paths, files are opened and texts are printed in one place.")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
