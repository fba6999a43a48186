# SPDX-License-Identifier: MIT
"""The same numbers and words where a comma divides numbers and i has no capital I: German and Turkish locales.

They are made with Debian's package `locales` into a folder of their own; nothing of the machine is changed.
"""

import json
import os
import re
import shutil
import subprocess
import sys

import pytest

PROGRAM = os.environ["TALUS_PROGRAM"]
FOREIGN = {"de_DE": ",", "tr_TR": ","}
VOLATILE = {"machine", "started", "seconds", "wall", "cpu", "circles_per_second", "timing", "stage_steps", "case_file"}

CASE = """
[geometry]
box = [[0, 0], [30, 15]]
[[geometry.polygon]]
name = "dike"
points = [[0, 0], [30, 0], [30, 5], [20, 5], [10, 12.5], [0, 12.5]]
[mesh]
size = 1.5
[regions]
dike = "SILT_I"
[materials.SILT_I]
model = "mohr_coulomb"
unit_weight = "18.5 kN/m3"
cohesion = "7.25 kPa"
friction_angle = 27.5
dilatancy_angle = 0
tensile_strength = 0
young_modulus = "20 MPa"
poisson_ratio = 0.3
[[boundary]]
on = "left"
fix = "normal"
[[boundary]]
on = "right"
fix = "normal"
[[boundary]]
on = "bottom"
fix = "full"
[[stage]]
name = "gravity"
duration = 0.5
[analysis]
methods = ["lem", "fem", "mpm"]
[lem]
methods = ["spencer"]
entry_exit = { exits = 6, entries = 6, depths = 5 }
noncircular = false
referee = false
[fem]
meshes = 1
resolution = 0.1
[[output.monitor]]
name = "crest"
at = [10, 12.5]
"""

# Sets the locale as programs with windows do, calculates, and prints the summary.
IN_PYTHON = """
import json, locale, sys
locale.setlocale(locale.LC_ALL, sys.argv[3])
assert locale.localeconv()["decimal_point"] == sys.argv[4]
import talus
results = talus.run(talus.Case.read(sys.argv[1]), sys.argv[2], threads=1)
print(repr(results.factor_of_safety))
"""


@pytest.fixture(scope="session", params=FOREIGN)
def foreign(request, tmp_path_factory):
    """The environment of a foreign locale, and its name."""
    if shutil.which("localedef") is None or not os.path.exists("/usr/share/i18n/locales/" + request.param):
        pytest.skip("there is no localedef with its sources (Debian: locales), so other locales are NOT tried")
    folder = tmp_path_factory.mktemp("locales")
    name = request.param + ".UTF-8"
    subprocess.run(["localedef", "-i", request.param, "-f", "UTF-8", str(folder / name)], check=True, capture_output=True)
    environment = os.environ | {"LOCPATH": str(folder), "LC_ALL": name, "LANG": name}
    shown = subprocess.run(["locale", "decimal_point"], env=environment, capture_output=True, text=True).stdout.strip()
    assert shown == FOREIGN[request.param]
    return environment, name


def call(*words, **environment):
    return subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, **environment)


def strip(value):
    """Without what differs from run to run."""
    if isinstance(value, dict):
        return {key: strip(v) for key, v in value.items() if key not in VOLATILE}
    if isinstance(value, list):
        return [strip(v) for v in value]
    return drop_seconds(value) if isinstance(value, str) else value


def drop_seconds(text):
    """Without the column of seconds, and the sentence on them."""
    return re.sub(r"(  +[\d.]+$| +Computing time: .*|^Computing time: .*)", "", text, flags=re.M)


def run_program(folder, variables):
    """The files of a run and its plots in the folder, and what it printed."""
    (folder / "case.toml").write_text(CASE)
    done = call("run", folder / "case.toml", "-o", folder / "out", "--threads", 1, env=variables)
    assert done.returncode == 0, done.stderr
    assert call("plot", folder / "out", env=variables).returncode == 0
    return folder / "out", drop_seconds(done.stdout.replace(str(folder), ""))


def run_python(folder, variables, locale, point):
    (folder / "case.toml").write_text(CASE)
    words = [sys.executable, "-c", IN_PYTHON, str(folder / "case.toml"), str(folder / "out"), locale, point]
    done = subprocess.run(words, env=variables, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return folder / "out", done.stdout


@pytest.fixture(scope="module")
def program_at_home(tmp_path_factory):
    return run_program(tmp_path_factory.mktemp("program"), None)


@pytest.fixture(scope="module")
def python_at_home(tmp_path_factory):
    return run_python(tmp_path_factory.mktemp("python"), None, "C", ".")


def read_summary(folder):
    return strip(json.loads((folder / "summary.json").read_text()))


def test_a_run_has_the_same_bits_and_words(foreign, tmp_path, program_at_home):
    environment, _ = foreign
    (here, told_here), (there, told_there) = program_at_home, run_program(tmp_path, environment)
    assert told_here == told_there
    names = sorted(file.name for file in here.iterdir())
    assert names == sorted(file.name for file in there.iterdir())
    assert read_summary(here) == read_summary(there)
    for name in names:
        if name.endswith((".csv", ".svg", ".vtkhdf", ".vtu", ".xdmf")):
            assert (here / name).read_bytes() == (there / name).read_bytes(), name


def test_mistakes_are_told_in_the_same_words(foreign, tmp_path):
    environment, _ = foreign
    (tmp_path / "case.toml").write_text(CASE.replace('"7.25 kPa"', '"7,25 kPa"').replace("friction_angle", "FRICTION_ANGLE"))
    here, there = (call("check", "case.toml", env=variables, cwd=tmp_path) for variables in (None, environment))
    assert here.returncode == there.returncode == 2
    assert here.stderr == there.stderr and "7,25 kPa" in here.stderr


def test_python_calculates_the_same_under_a_set_locale(foreign, tmp_path, python_at_home):
    environment, name = foreign
    (here, told_here), (there, told_there) = python_at_home, run_python(tmp_path, environment, name, ",")
    assert told_here == told_there
    assert read_summary(here) == read_summary(there)
