# SPDX-License-Identifier: MIT
"""A case in code equals a file, and its faults are reported in the words of the command line."""

import pickle
import tomllib
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import talus

FAULTS = {
    "a misspelt key": ("cohesion = \"2 kPa\"", "cohesoin = \"2 kPa\""),
    "several at once": ("size = 0.75", "size = \"-1 kg\"\nalgorithm = \"fast\"\nrefin = 3"),
    "no TOML": ("[regions]", "[regions"),
    "a missing block": ("[[geometry.polygon]]", "[[geometry.line]]"),
    "names that do not fit": ("soil = \"sand\"", "soil = \"gravel\""),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_faults_of_a_file_are_the_command_lines(fault, source, tmp_path, command_line):
    text = (source / "examples/dry_slope/case.toml").read_text().replace('algorithm = "delaunay"\n', "")
    old, new = FAULTS[fault]
    assert text.count(old) == 1
    (tmp_path / "case.toml").write_text(text.replace(old, new))
    program = command_line("check", "case.toml", cwd=tmp_path)
    assert program.returncode == talus.InputError.exit_code
    with pytest.MonkeyPatch.context() as patch, pytest.raises(talus.InputError) as error:
        patch.chdir(tmp_path)
        talus.Case.read("case.toml").validate()
    assert str(error.value) + "\n" == program.stderr
    assert [str(finding) for finding in error.value.findings] == program.stderr.splitlines()


def test_a_file_that_is_not_there_is_the_command_lines_sentence(tmp_path, command_line):
    path = str(tmp_path / "no.toml")
    with pytest.raises(talus.InputError) as error:
        talus.Case.read(path)
    assert str(error.value) + "\n" == command_line("check", path).stderr


def test_unknown_names_are_refused_at_once_with_the_readers_suggestion(slope):
    case = slope()
    before = case.to_toml()
    attempts = [
        (lambda: setattr(case.mesh, "sise", 3), "unknown key 'sise' in [mesh]; did you mean 'size'?"),
        (lambda: setattr(case.materials["sand"], "cohesoin", 3), "in [materials.sand]; did you mean 'cohesion'?"),
        (lambda: case.stage.append(name="x", duraton=3), "in [[stage]]; did you mean 'duration'?"),
        (lambda: setattr(case, "mesh", dict(sise=3)), "did you mean 'size'?"),
        (lambda: talus.Case(geometri={}), "at the top of the file; did you mean 'geometry'?"),
        (lambda: case.__setitem__("output.monitor.crest.att", [0, 0]), "in [[output.monitor]]; did you mean 'at'?"),
    ]
    for attempt, sentence in attempts:
        with pytest.raises(talus.InputError) as error:
            attempt()
        assert sentence in str(error.value)
    assert case.to_toml() == before
    with pytest.raises(AttributeError, match="did you mean 'size'"):
        case.mesh.sise
    with pytest.raises(KeyError, match="there are 'sand'"):
        case.materials["gravel"]


def test_changes_by_attribute_item_and_path_are_those_of_the_command_line(source, tmp_path, command_line):
    file = source / "examples/dry_slope/case.toml"
    case = talus.Case.read(file)
    assert case.to_toml() == file.read_text()
    as_read = case.echo()
    case.materials["sand"].cohesion = "3 kPa"
    case["strength_reduction.curve.step"] = np.float64(0.1)
    case.strength_reduction.curve.from_ = 1.1
    case["stage.gravity.damping"] = 0.7
    case.boundary["left"].fix = "full"
    case.geometry.polygon[0].points = np.array([[0, 0], [44, 0], [44, 5.0], [32, 5], [12, 15], [0, 15]])
    case.output.monitor["toe"].at = (31, 5)
    case.mesh.points_per_element = None  # back to the default
    echo = case.echo()
    assert echo != as_read
    assert echo["materials"]["sand"]["cohesion"] == {"value": 3.0, "unit": "kPa", "given": True}
    assert echo["strength_reduction"]["curve"]["step"]["value"] == 0.1
    assert echo["strength_reduction"]["curve"]["from"]["value"] == 1.1
    assert echo["stage"][0]["damping"]["value"] == 0.7
    assert echo["boundary"][1]["fix"]["value"] == "full"
    assert echo["output"]["monitor"][1]["at"]["value"] == [31, 5]
    assert echo["mesh"]["points_per_element"] == {"value": 3, "given": False}
    # The text is a case file for the command line as well, and means the same.
    (tmp_path / "changed.toml").write_text(case.to_toml())
    assert command_line("check", tmp_path / "changed.toml").returncode == 0
    assert talus.Case.read(tmp_path / "changed.toml").echo() == echo


def test_every_key_of_the_template_can_be_read_and_written_back(tmp_path, command_line):
    template = command_line("template").stdout
    case = talus.Case.from_toml(template)
    echo = case.echo()
    again = talus.Case(**case.to_dict())
    assert again.echo() == echo


def test_looking_at_a_block_does_not_give_it(slope):
    case = slope()
    before = case.to_toml()
    assert case.strength_reduction.frozen.rest.hold is None
    assert "gravity" not in case and "hold" not in case.rest and len(case.traction) == 0
    assert case.to_toml() == before


def test_lines_of_findings_are_lines_of_the_text(slope):
    case = slope(mesh__size=-1, materials__sand__porosity=2)
    with pytest.raises(talus.InputError) as error:
        case.validate()
    assert len(error.value.findings) == 2
    lines = case.to_toml().splitlines()
    assert {lines[f.line - 1] for f in error.value.findings} == {"size = -1", "porosity = 2"}
    with pytest.raises(talus.InputError) as same:
        talus.run(case, "never")
    assert str(same.value) == str(error.value)


def test_mesh_files_are_relative_to_the_folder_of_the_case(source, tmp_path):
    case = talus.Case.read(source / "examples/dry_slope/case.toml")
    text = case.to_toml().split("[geometry]")[0] + '[mesh]\nfile = "ready.msh"\n[materials' + (
        case.to_toml().split("[materials", 1)[1]
    )
    (tmp_path / "case.toml").write_text(text)
    case = talus.Case.read(tmp_path / "case.toml")
    for _ in range(2):  # as read, and changed
        with pytest.raises(talus.InputError, match=str(tmp_path / "ready.msh")):
            talus.run(case, tmp_path / "results")
        case.title = "changed"


def test_help_is_the_declarations(source):
    assert "kPa" in talus.describe("materials.sand.cohesion")
    assert type(talus.Case().mesh).size.__doc__ in talus.describe("mesh.size")
    assert '"meshadapt"' in talus.describe("mesh.algorithm")
    assert "default 0.9" in talus.describe("stage.gravity.courant")
    assert "from_" in dir(talus.Case().strength_reduction.curve)
    with pytest.raises(KeyError, match="size"):
        talus.describe("mesh.sise")


def test_python_values_become_those_of_a_case_file(slope):
    case = slope()
    case.mesh.size = np.float32(0.5)
    case.materials["sand"].porosity = Fraction(2, 5)
    case.materials["sand"].cohesion = np.str_("3 kPa")
    case.mesh.points_per_element = np.int64(6)
    case.mesh.refine = []
    case.geometry.polygon[0].points = zip([0, 44, 44, 32, 12, 0], [0, 0, 5, 5, 15, 15])
    case.strength_reduction.curve.refine = np.bool_(False)
    case.strength_reduction.curve.runout = range(2, 4)
    case.analysis.kind = "strength_reduction"
    case.validate()
    data = tomllib.loads(case.to_toml())
    assert data["mesh"]["size"] == 0.5 and data["mesh"]["points_per_element"] == 6
    assert data["materials"]["sand"]["porosity"] == 0.4 and data["materials"]["sand"]["cohesion"] == "3 kPa"
    assert data["geometry"]["polygon"][0]["points"][4] == [12, 15]
    assert data["strength_reduction"]["curve"] == {"refine": False, "runout": [2, 3]}
    case = slope()
    case.mesh.file = Path("a") / "b.msh"
    assert tomllib.loads(case.to_toml())["mesh"]["file"] == "a/b.msh"


@pytest.mark.parametrize("value", [1 + 2j, object(), b"3", {1.5, 2.0}, [1, None], lambda: 3], ids=repr)
def test_what_no_case_file_can_say_is_refused_at_once(value, slope):
    case = slope()
    before = case.to_toml()
    with pytest.raises(talus.InputError, match="'mesh.size' cannot be .*: a case holds numbers"):
        case.mesh.size = value
    assert case.to_toml() == before


def test_tables_and_lists_keep_their_kind(slope):
    case = slope()
    before = case.to_toml()
    for name, value, sentence in [
        ("mesh", 3, "'mesh' is a table of keys: give a dict, not 3"),
        ("materials.sand", 3, "'materials.sand' is a table of keys"),
        ("materials", dict(sand=3), "'materials.sand' is a table of keys"),
        ("stage", dict(name="a"), "'stage' is a list of tables"),
        ("stage.gravity.rest", 1, "rest"),
    ]:
        with pytest.raises(talus.InputError, match=sentence):
            case[name] = value
    with pytest.raises(talus.InputError, match="'stage' is a table of keys"):
        case.stage.append("gravity")
    assert case.to_toml() == before


def test_tables_are_used_like_dicts(slope):
    case, other = slope(), slope()
    assert case == other and case.mesh == other.mesh and case == pickle.loads(pickle.dumps(case))
    for name, material in case.materials.items():
        material.update(cohesion="4 kPa", porosity=0.3)
    assert name == "sand" and case != other
    assert case.echo()["materials"]["sand"]["cohesion"]["value"] == 4
    assert dict(case.mesh) == {"size": 3, "points_per_element": 3} == dict(**case.mesh)
    assert "cohesion = &quot;4 kPa&quot;" in case._repr_html_()


def test_tables_show_their_names(slope):
    case = slope()
    assert repr(case.materials.sand).startswith("[materials.sand] {'model': 'mohr_coulomb'")
    assert repr(case.mesh).startswith("[mesh] {")
    assert repr(case.stage[0]).startswith("[[stage]] {'name'")
    case.materials["sand"]["water.retention"] = "saturated"
    assert repr(case.materials.sand.water) == "[materials.sand.water] {'retention': 'saturated'}"
