#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""`make demo` and `make test` install what they build and test: the package lists of the Makefile against .ci/run, modules and tests.

Beyond these lists .ci/run installs only lists without which it goes on with a SKIP line and which a test names where it skips. Every
module of src/ and every Python module that a test imports comes from a package of these lists, or the test skips without it.
"""
import ast
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LIST = re.compile(r"tools/apt-packages[\w-]*\.txt")
# Module of src/ → the package it is made with
MODULES = {"talus_gmsh": "libgmsh-dev", "talus_gdal": "libgdal-dev", "talus_xlsx": "libxlsxwriter-dev", "talus_http": "libcpp-httplib-dev", "talus_ranks": "petsc-dev"}
# Module of Python → its package; PIL comes with matplotlib
IMPORTS = {"h5py": "python3-h5py", "matplotlib": "python3-matplotlib", "numpy": "python3-numpy", "PIL": "python3-matplotlib",
           "pytest": "python3-pytest", "tomli_w": "python3-tomli-w"}
INSIDE_PVPYTHON = {"paraview", "vtk", "vtkmodules"}  # tests of ParaView skip without its Python
# Programs that tests start: Chromium, gnuplot, rsvg-convert, gfortran, localedef
STARTED = {"chromium", "gnuplot-nox", "librsvg2-bin", "gfortran", "locales"}


def read(name):
    return (ROOT / name).read_text(encoding="utf-8")


def read_packages(*lists):
    return {line.split("#")[0].strip() for name in lists for line in read(name).splitlines()} - {""}


def list_installed_by_make(setup, makefile):
    """The lists of tools/setup.sh without arguments, which every target that builds calls first."""
    if not re.search(r"^SETUP +\?= tools/setup\.sh$", makefile, re.M) or not re.search(r"^setup:\n\t@\$\(SETUP\)$", makefile, re.M):
        raise SystemExit("check_packages: the target setup of the Makefile does not call tools/setup.sh as this check reads it")
    return re.findall(r"^(?:needed|optional)=(tools/apt-packages[\w-]*\.txt)$", setup, re.M)


def find_faults_of_ci(ci, installed, tests):
    for number, line in enumerate(ci.splitlines(), 1):
        if line.lstrip().startswith("#"):
            continue
        if re.search(r"\b(apt-get|apt|pip3?|npm) (install|ci)\b", line):
            yield f".ci/run:{number}: only tools/setup.sh installs, so that make demo and make test can do the same"
        for name in set(LIST.findall(line)) - set(installed) if "tools/setup.sh" in line else ():
            if "SKIP: " not in line:
                yield f".ci/run:{number}: {name} is neither installed by make demo nor followed by a SKIP line where it cannot be had"
            if not any(name in text and "SKIP" in text for text in tests.values()):
                yield f".ci/run:{number}: no test names {name} where it skips"


def find_faults_of_modules(cmake, everyday, packages, optional):
    for module in re.findall(r"add_library\((\w+) MODULE", cmake):
        if MODULES.get(module) not in packages | optional:
            yield f"src/CMakeLists.txt: no list has the package of the module {module} (MODULES of this check names it)"
        if module not in re.search(r"foreach\(more ([^)]*)\)", everyday)[1].split():
            yield f"CMakeLists.txt: the module {module} is not part of what make demo builds"


def list_imports(text):
    """Modules that a file cannot do without: those inside `try` with ImportError are left out."""
    def visit(node):
        if isinstance(node, ast.Try) and any("ImportError" in ast.dump(handler) for handler in node.handlers):
            return
        if isinstance(node, ast.Import):
            yield from (name.name for name in node.names)
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            yield node.module
        for child in ast.iter_child_nodes(node):
            yield from visit(child)

    return {name.split(".")[0] for name in visit(ast.parse(text))}


def find_faults_of_imports(tests, own, packages):
    for name, text in tests.items():
        for module in sorted(list_imports(text) - sys.stdlib_module_names - INSIDE_PVPYTHON - own) if name.endswith(".py") else ():
            if IMPORTS.get(module) not in packages:
                yield f"{name}: no list of make demo has the package of '{module}' (IMPORTS of this check names it), and the test does not skip without it"


def test_itself():
    """Each kind of fault is found."""
    makes = ["tools/apt-packages.txt"]
    test = {"tests/a.py": "print('SKIP: tools/apt-packages-x.txt')"}
    line = "tools/setup.sh tools/apt-packages-x.txt"
    assert not list(find_faults_of_ci(f"# apt-get install a\n{line} || echo 'SKIP: …'\ntools/setup.sh tools/apt-packages.txt", makes, test))
    assert len(list(find_faults_of_ci(f"sudo apt-get install a\n{line}\n{line} || echo 'SKIP: …'", makes, {}))) == 4
    everyday = "foreach(more talus_gdal)"
    assert not list(find_faults_of_modules("add_library(talus_gdal MODULE a)", everyday, {"libgdal-dev"}, set()))
    assert len(list(find_faults_of_modules("add_library(talus_gdal MODULE a)\nadd_library(talus_new MODULE b)", everyday, set(), set()))) == 3
    python = {"tests/a.py": "import os, numpy.linalg\nfrom own import b\ntry:\n  import scipy\nexcept ImportError:\n  pass\ndef c():\n  import pandas"}
    assert [fault.split("'")[1] for fault in find_faults_of_imports(python, {"own"}, {"python3-numpy"})] == ["pandas"]


def main():
    test_itself()
    ci = read(".ci/run")
    installed = list_installed_by_make(read("tools/setup.sh"), read("Makefile"))
    packages, optional = read_packages(*installed), read_packages(*set(LIST.findall(ci)) - set(installed))
    files = [*(ROOT / "tests").rglob("*"), *(ROOT / "python/tests").rglob("*")]
    tests = {path.relative_to(ROOT).as_posix(): path.read_text(encoding="utf-8") for path in files if path.suffix in (".py", ".sh")}
    own = {path.stem for folder in ("tests", "tools", "python", "docs/manual") for path in (ROOT / folder).rglob("*.py")}
    own |= {path.parent.name for folder in ("tools", "python") for path in (ROOT / folder).rglob("*.py")}
    faults = [*find_faults_of_ci(ci, installed, tests), *find_faults_of_modules(read("src/CMakeLists.txt"), read("CMakeLists.txt"), packages, optional),
              *find_faults_of_imports(tests, own, packages),
              *(f"tests start programs of {package}, which no list of make demo has" for package in sorted(STARTED - packages))]
    print("\n".join(faults) if faults else f"{len(packages)} packages are what the build and the tests need")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
