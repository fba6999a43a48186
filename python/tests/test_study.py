# SPDX-License-Identifier: MIT
"""A study from Python is the command line's study, and its table is what the runs give."""

import csv
import math
import pickle

import numpy as np
import pytest

import talus
from conftest import make_uncertain


def make_study(slope, **changes):
    """A column of three variants, a fraction of a second each; base and two sizes."""
    case = slope(stage=[dict(name="gravity", duration=1, damping=0.75)], **changes)
    case.study.vary = [dict(key="mesh.size", values=[4, "500 cm"])]
    return case


def test_the_table_is_the_command_lines_and_that_of_the_runs(slope, tmp_path, command_line):
    case = make_study(slope)
    (tmp_path / "case.toml").write_text(case.to_toml())
    program = command_line("study", tmp_path / "case.toml", "-o", tmp_path / "program")
    assert program.returncode == 0, program.stderr
    study = talus.study(case, tmp_path / "python", threads=2)
    theirs = talus.Study(tmp_path / "program")
    assert study.names == theirs.names == ["base", "size_4", "size_500_cm"] == list(study)
    assert study.labels[1] == "size = 4" and study.keys == ["mesh.size"]
    assert set(study.statuses.values()) == {"finished"} and study.reasons == {}
    assert list(study.table) == list(theirs.table)
    for name in set(study.table) - {"wall time"}:
        assert np.array_equal(study.table[name], theirs.table[name]), name
    # The table is study.csv, and its numbers are those of the variants.
    with open(tmp_path / "python/study.csv") as file:
        head, *rows = csv.reader(file)
    assert head == [n if (u := study.table.units[n]) == "-" else f"{n} [{u}]" for n in study.table]
    assert list(study.table["mesh.size"]) == [3, 4, 5] == [float(row[head.index("mesh.size [m]")]) for row in rows]
    assert list(study.table["points"]) == [len(study[name].frame()) for name in study]
    assert study.rows[2]["variant"] == "size_500_cm" and study.rows[2]["points"] == study.table["points"][2]
    assert study.record.variants[1].name == study.labels[1] and study.record.vary[0].key == "mesh.size"
    assert study[2].summary == study["size_500_cm"].summary
    assert (tmp_path / "python/report.html").exists()
    assert "<td>size = 4</td>" in study._repr_html_()
    assert pickle.loads(pickle.dumps(study)).names == study.names


def test_values_may_be_arrays_and_leave_the_case_alone(slope, tmp_path):
    case = slope(stage=[dict(name="gravity", duration=0.5)])
    before = case.to_toml()
    study = talus.study(case, tmp_path / "s", {"mesh.size": np.linspace(4, 5, 2)}, report=False)
    assert list(study.table["mesh.size"]) == [3, 4, 5] and case.to_toml() == before
    assert not (tmp_path / "s/report.html").exists()
    with pytest.raises(talus.InputError, match="is the folder of a study"):
        talus.Results(tmp_path / "s")
    with pytest.raises(KeyError, match="there are base, size_4"):
        study["size_9"]
    with pytest.raises(talus.FolderExists):
        talus.study(case, tmp_path / "s", {"mesh.size": [4]})
    with pytest.raises(talus.InputError, match="sise"):
        talus.study(case, tmp_path / "never", {"mesh.sise": [4]})
    with pytest.raises(talus.InputError, match="vary"):
        talus.study(case, tmp_path / "never")
    assert not (tmp_path / "never").exists()
    with pytest.raises(talus.InputError, match="has no study.json"):
        talus.Study(tmp_path)


def test_a_stopped_study_goes_on(slope, tmp_path):
    case = make_study(slope)
    seen = []

    def stop(progress):
        seen.append(progress)
        return False

    with pytest.raises(talus.Interrupted, match="of 3 variants finished; --resume continues with the others"):
        talus.study(case, tmp_path / "s", threads=1, progress=stop)
    assert len(seen) == 1 and "of 3 variants done" in seen[0].line and seen[0].fraction is None
    stopped = talus.Study(tmp_path / "s")
    assert "not started" in stopped.statuses.values()
    # On a busy machine it may stop before the first variant is finished; then no result has a column.
    assert "points" not in stopped.table or math.isnan(stopped.table["points"][-1])
    with pytest.raises(talus.InputError, match="is not started"):
        stopped[-1]
    assert (tmp_path / "s/report.html").exists()
    resumed = talus.study(case, tmp_path / "s", resume=True)
    assert set(resumed.statuses.values()) == {"finished"}


def test_a_callback_that_raises_stops_a_study(slope, tmp_path):
    def fail(progress):
        raise RuntimeError("enough")

    with pytest.raises(talus.Interrupted) as error:
        talus.study(make_study(slope), tmp_path / "s", threads=1, progress=fail)
    assert str(error.value.__cause__) == "enough"


def test_a_variant_that_fails_leaves_the_others(slope, tmp_path):
    # Under a hundred million g the first steps are faster than any wave.
    case = slope(stage=[dict(name="gravity", duration=1)])
    with pytest.raises(talus.Unstable, match="1 of 2 variants did not finish"):
        talus.study(case, tmp_path / "s", {"gravity.acceleration": [1e9]})
    study = talus.Study(tmp_path / "s")
    assert list(study.statuses.values()) == ["finished", "unstable"] and list(study.reasons) == [study.names[1]]
    assert study["base"].status == "finished" and (tmp_path / "s/report.html").exists()


def test_samples_are_those_of_the_command_line(tmp_path, command_line):
    case = make_uncertain(50)
    (tmp_path / "case.toml").write_text(case.to_toml())
    program = command_line("study", tmp_path / "case.toml", "-o", tmp_path / "program")
    assert program.returncode == 0, program.stderr
    study = talus.study(case, tmp_path / "python", report=False)
    assert (tmp_path / "python/samples.csv").read_bytes() == (tmp_path / "program/samples.csv").read_bytes()
    assert len(study) == 0 and "50 samples" in repr(study)
    factor = study.samples["factor of safety"]
    assert study.sampling["factor"]["mean"] == pytest.approx(factor.mean(), rel=1e-12)
    assert study.samples.units["materials.soil.cohesion"] == "kPa" and list(study.samples["sample"]) == list(range(1, 51))
    (tmp_path / "python/samples.csv").unlink()
    with pytest.raises(talus.InputError, match="has no samples"):
        talus.Study(tmp_path / "python").samples


def test_curves_of_a_study_are_those_of_its_variants(reduction, tmp_path):
    from matplotlib import pyplot

    case = reduction()
    case.strength_reduction.frozen.enabled = False
    study = talus.study(case, tmp_path / "s", {"materials.sand.cohesion": [8]})
    axes = talus.plot.plot_curves(study)
    for line, name in zip(axes.lines, study):
        assert np.allclose(line.get_ydata(), 1000 * study[name].curve.displacement)
    assert [text.get_text() for text in axes.get_legend().get_texts()] == study.labels
    # More cohesion, less displacement, whatever the mesh.
    assert (study[1].curve.displacement < study[0].curve.displacement).all()
    pyplot.close("all")
