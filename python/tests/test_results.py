# SPDX-License-Identifier: MIT
"""The arrays are what lies in the files, as h5py and the csv module read them, and no copies."""

import csv
import gc
import pickle

import h5py
import numpy as np
import pytest

import talus


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    from conftest import make_reduction

    case = make_reduction()
    case.output.frame_interval = 1
    case.output.cells = case.output.nodes = True
    case.strength_reduction.curve.runout = [2.0]
    case.strength_reduction.curve.runout_time = 5
    case.strength_reduction.curve.displacement_ratio = 0.005  # of the height: less than the last trial moves
    return talus.run(case, tmp_path_factory.mktemp("results") / "run")


def test_frames_are_what_h5py_reads(results):
    frames = list(results)  # HDF5 refuses to open a file twice in one process with other settings of its locks
    with h5py.File(results.folder / "results.vtkhdf") as file:
        grid, steps = file["VTKHDF"], file["VTKHDF/Steps"]
        assert len(frames) == steps.attrs["NSteps"] > 2
        assert np.array_equal(results.times, steps["Values"])
        assert set(results.fields) | {"id", "material"} == set(grid["PointData"])
        for i, frame in enumerate(frames):
            count, first = grid["NumberOfPoints"][steps["PartOffsets"][i]], steps["PointOffsets"][i]
            assert len(frame) == count > 0
            assert np.array_equal(frame.positions, grid["Points"][first : first + count])

            def read(name):
                start = steps["PointDataOffsets"][name][i]
                return grid["PointData"][name][start : start + count]

            assert np.array_equal(frame.ids, read("id"))
            assert np.array_equal(frame.materials, read("material"))
            for name in results.fields:
                assert np.array_equal(frame.field(name), read(name)), name
                assert frame.unit(name).encode() == grid["PointData"][name].attrs["unit"]
    assert frame.field("stress").shape == (len(frame), 6)
    assert results.stages[0] == "gravity" and results.frame_at(-1).time == 0
    with pytest.raises(talus.InputError, match="there is no field 'pressure'.*deviatoric_strain"):
        frame.field("pressure")
    with pytest.raises(IndexError):
        results[len(results)]


def test_the_mesh_is_what_h5py_reads(results):
    mesh = results.mesh
    with h5py.File(results.folder / "mesh.vtkhdf") as file:
        grid, steps = file["VTKHDF"], file["VTKHDF/Steps"]
        i = steps.attrs["NSteps"] - 1
        part = steps["PartOffsets"][i]
        first, count = steps["PointOffsets"][i], grid["NumberOfPoints"][part]
        assert np.array_equal(mesh.nodes, grid["Points"][first : first + count])
        first, count = steps["ConnectivityIdOffsets"][i], grid["NumberOfConnectivityIds"][part]
        assert np.array_equal(mesh.elements.ravel(), grid["Connectivity"][first : first + count])
        start = steps["PointDataOffsets"]["mass"][i]
        assert np.array_equal(mesh.node_fields["mass"], grid["PointData"]["mass"][start : start + len(mesh.nodes)])
    assert mesh.element_fields["points"].sum() == len(results.frame())


def address(array):
    return array.__array_interface__["data"][0]


def test_arrays_are_the_librarys_memory_and_keep_it_alive(results):
    frame = results.frame()
    arrays = {"positions": lambda f: f._frame.positions, "ids": lambda f: f._frame.ids}
    arrays["stress"] = lambda f: f._frame.fields["stress"][1]
    arrays["nodes"] = lambda f: f._frame.mesh.nodes
    for name, get in arrays.items():
        # Asked for twice, a copy would lie elsewhere: both are alive.
        first, second = get(frame), get(frame)
        assert address(first) == address(second), name
        assert not first.flags.owndata and not first.flags.writeable and first.base is not None
    kept = frame.field("stress")
    value, column = kept.copy(), results.history["time"]
    expected = column.copy()
    del frame, first, second
    gc.collect()
    np.random.default_rng(1).random(3_000_000)  # freed memory would be written over
    assert np.array_equal(kept, value) and np.array_equal(column, expected)
    with pytest.raises(ValueError, match="read-only"):
        kept[0, 0] = 1


def read_csv(path):
    with open(path) as file:
        head, *rows = csv.reader(file)
    return head, np.array(rows, dtype=float)


def test_histories_are_the_tables(results):
    for history, name in ((results.history, "history.csv"), (results.monitors, "monitors.csv")):
        head, rows = read_csv(results.folder / name)
        assert head == [f"{column} [{history.units[column]}]" for column in history]
        for i, column in enumerate(history):
            assert np.array_equal(history[column], rows[:, i], equal_nan=True)
    assert results.monitors.units["crest.displacement_x"] == "mm"


def test_curve_and_trials_belong_together(results):
    curve = results.curve
    assert list(curve.srf) == list(results.trials) == [1.4, 1.6, 1.8, 2.0]
    for factor, row in zip(curve.srf, curve):
        trial = results.trials[factor]
        assert trial.summary["displacement"] == row.displacement
        assert trial.units == results.units and trial.materials == ["sand"]
    # The displacement of the curve is the largest of a point in the trial's last frame.
    moved = np.linalg.norm(results.trials[1.8].frame().field("displacement"), axis=1)
    assert moved.max() == pytest.approx(curve.displacement[2], rel=1e-12)
    assert results.criteria["frozen"] == results.factor_of_safety


def test_a_run_without_a_curve_says_so(slope, tmp_path):
    results = talus.run(slope(), tmp_path / "run")
    assert results.curve is None and results.factor_of_safety is None and results.trials == {} and results.mesh is None
    with pytest.raises(talus.InputError, match="there is no curve"):
        talus.plot.plot_curve(results)
    with pytest.raises(talus.InputError, match="there is no folder"):
        talus.Results(tmp_path / "nowhere")
    (tmp_path / "empty").mkdir()
    with pytest.raises(talus.InputError, match="there are no frames of a run"):
        talus.Results(tmp_path / "empty").frame()


def test_plots_show_the_values_in_the_units_of_the_case(results):
    from matplotlib import pyplot

    axes = talus.plot.plot_curve(results)
    points = axes.lines[0]
    assert np.allclose(points.get_ydata(), 1000 * results.curve.displacement)  # mm
    assert axes.get_ylabel() == "largest displacement [mm]"
    assert f"{results.factor_of_safety:.3f}  factor of safety" in [t.get_text() for t in axes.get_legend().get_texts()]

    frame = results.frame()
    figure, given = pyplot.subplots()
    axes = talus.plot.plot_section(frame, "mean_stress", ax=given, outline=False)
    assert axes is given and not axes.lines and axes.get_aspect() == 1
    discs = axes.collections[0]
    kilopascals = np.sort(frame.field("mean_stress") / 1000)
    assert np.allclose(np.sort(discs.get_array()), kilopascals)
    assert "kPa" in figure.axes[1].get_xlabel()
    # Discs that just cover the squares of the points.
    assert np.isclose((discs._widths * 2) ** 2 / 2, frame.field("volume")).all()

    axes = talus.plot.plot_section(results.trials[2.0], "displacement.x")
    assert np.allclose(axes.lines[0].get_xdata()[[0, -1]], [0, 0])  # a closed outline, from the run's summary
    ends = axes.collections[0].get_clim()
    shown = 1000 * results.trials[2.0].frame().field("displacement")[:, 0]
    has_both_signs = shown.min() < 0 < shown.max()
    assert ends == ((-abs(shown).max(), abs(shown).max()) if has_both_signs else (shown.min(), shown.max()))
    with pytest.raises(talus.InputError, match="'displacement' has no component 'w'; it has magnitude, x, y, z"):
        talus.plot.plot_section(results, "displacement.w")
    pyplot.close("all")


def test_a_point_is_followed_by_its_id(results):
    trial = results.trials[2.0]
    crest = trial[0].find_point((12, 15))
    distances = np.linalg.norm(trial[0].positions[:, :2] - (12, 15), axis=1)
    assert distances[list(trial[0].ids).index(crest)] == distances.min()
    path = trial.point_history(crest, "position", "stress", "volume")
    assert np.array_equal(path["time"], trial.times) and len(trial) > 2
    assert path.units == {"time": "s", "position": "m", "stress": "Pa", "volume": "m3"}
    for i, frame in enumerate(trial):
        row = int(np.flatnonzero(frame.ids == crest)[0])
        assert np.array_equal(path["position"][i], frame.positions[row])
        assert np.array_equal(path["stress"][i], frame.field("stress")[row])
    # The displacement is the way that the point has gone.
    way = trial.point_history([crest, 0], "position", "displacement")
    gone = np.diff(way["position"], axis=0)
    assert way["position"].shape == (len(trial), 2, 3)
    assert np.allclose(np.diff(way["displacement"], axis=0), gone, atol=1e-9)
    for wrong in (10**6, "crest", 1.5, [[1]]):
        with pytest.raises(talus.InputError, match="point"):
            trial.point_history(wrong)


def test_a_point_that_left_is_not_a_number():
    from talus.frames import follow_points

    class Moment:
        def __init__(self, time, ids):
            self.time, self.ids = time, np.array(ids)
            self.positions = np.array([[10.0 * i, 0, 0] for i in ids]).reshape(-1, 3)

        def __len__(self):
            return len(self.ids)

    history = follow_points([Moment(0, [3, 1, 2]), Moment(1, [2, 1])], [1, 3], ["position"])
    assert np.array_equal(history["position"][:, :, 0], [[10, 30], [10, np.nan]], equal_nan=True)


def test_named_results_and_comparisons_are_those_of_the_summary(slope, tmp_path):
    case = slope(output__length_unit="cm")
    case.compare = [
        dict(name="stage[gravity].displacement", value="1 mm", tolerance="9900 %", source="nowhere"),
        dict(name="mesh.points", value=1, tolerance=0.5, source="nowhere"),
    ]
    results = talus.run(case, tmp_path / "run")
    settled = results.results["stage[gravity].displacement"]
    largest = np.linalg.norm(results.frame().field("displacement"), axis=1).max()
    assert settled.si == pytest.approx(largest, rel=1e-12) and settled.unit == "cm"
    assert settled.value == pytest.approx(100 * largest, rel=1e-12) and float(settled) == settled.value
    first, second = results.comparisons
    assert first.passes and first.unit == "mm" and first.published == pytest.approx(1)
    assert first.computed == pytest.approx(1000 * largest) and first.tolerance == pytest.approx(99)
    assert not second.passes and second.computed == len(results.frame()) and second.unit == "-"
    assert "does not pass" in str(second) and "does not pass" in results._repr_html_()
    with pytest.raises(KeyError, match="there are .*mesh.points"):
        results.results["nothing"]


def test_the_time_of_failure_is_that_of_the_runout(results):
    listed = {entry["srf"]: entry.get("failure_time") for entry in results.summary["runouts"]}
    assert results.trials[2.0].failure_time == listed[2.0] and 0 < listed[2.0] < 5
    assert results.trials[1.4].failure_time is None
    # The factor may come from a sum of steps.
    assert results.trials[1.4 + 3 * 0.2] is results.trials[2.0]
    with pytest.raises(KeyError, match="there are 1.4, 1.6"):
        results.trials[1.5]


def test_a_number_that_two_meshes_leave_open_is_none():
    data = {"name": "runout.front_advance", "title": "advance of the front", "value": None, "unit": {"name": "ft", "si": 0.3048},
            "undetermined": "not determined (two meshes: 2.0 m and 4.0 m)"}
    result = talus.Result(data, "NamedResult")
    assert result.value is None and result.si is None and result.unit == "ft"
    assert str(result) == "advance of the front: not determined (two meshes: 2.0 m and 4.0 m)"
    with pytest.raises(ValueError, match="runout.front_advance is not determined"):
        float(result)
    assert talus.Result({**data, "value": 0.3048}, "NamedResult").value == 1


def test_indices_are_those_of_a_list(results):
    assert [frame.index for frame in results[:2]] == [0, 1] and results[np.int64(-1)].index == len(results) - 1
    for wrong in (1.5, "last", None):
        with pytest.raises(TypeError):
            results[wrong]
        with pytest.raises(TypeError):
            results.frame(wrong)


def test_histories_and_animations_are_drawn(results, tmp_path):
    from matplotlib import pyplot

    axes = talus.plot.plot_history(results.monitors, "crest.displacement_x", "crest.displacement_y")
    assert np.array_equal(axes.lines[1].get_ydata(), results.monitors["crest.displacement_y"])
    assert axes.get_ylabel() == "[mm]" and axes.get_xlabel() == "time [s]"
    with pytest.raises(talus.InputError, match="must have one unit: kinetic_energy .J., points"):
        talus.plot.plot_history(results, "kinetic_energy", "points")
    with pytest.raises(KeyError, match="there is no 'energy'"):
        talus.plot.plot_history(results, "energy")
    trial = results.trials[2.0]
    animation = talus.plot.animate_section(trial, "displacement.x")
    animation.save(tmp_path / "run.gif", writer="pillow")
    from PIL import Image

    with Image.open(tmp_path / "run.gif") as picture:
        assert picture.n_frames == len(trial)
    points = next(c for c in animation._fig.axes[0].collections)
    ends = [1000 * end(frame.field("displacement")[:, 0]) for frame in trial for end in (np.min, np.max)]
    assert points.get_clim()[1] == pytest.approx(max(map(abs, ends)))  # one range for all frames
    pyplot.close("all")


def test_data_frames_have_a_column_for_each_component(results):
    try:
        import pandas  # noqa: F401
    except ImportError:
        with pytest.raises(ImportError, match="needs pandas"):
            results.frame().to_dataframe()
        pytest.skip("pandas is not installed")
    frame = results.frame()
    table = frame.to_dataframe()
    assert np.array_equal(table["stress.xy"], frame.field("stress")[:, 3]) and table.attrs["units"]["stress.xy"] == "Pa"
    assert list(table.index) == list(frame.ids) and np.array_equal(table["position.y"], frame.positions[:, 1])
    assert len(results.history.to_dataframe()) == len(results.history["time"])


def test_slices_and_elements_alone_have_a_factor_and_surfaces(slope, tmp_path):
    from matplotlib import pyplot

    case = slope(analysis__methods=["lem", "fem"], analysis__kind="strength_reduction")
    case.lem.methods = ["bishop", "spencer"]
    case.lem.entry_exit = dict(exits=8, entries=8, depths=7)
    case.lem.referee = False
    case.fem.meshes = 1
    case.fem.resolution = 0.05
    case.output.length_unit = "cm"
    results = talus.run(case, tmp_path / "run")
    listed = {row.surface: row.factor for row in reversed(results.methods)}  # of a surface the first row
    assert listed["fem.band"] == results.results["fem.factor"].value
    assert results.factor_of_safety == min(listed["fem.band"], results.results["lem.factor"].value)
    assert results.methods[0].title == "Bishop simplified"
    assert "Bishop simplified, critical circle" in repr(results.methods)
    assert "<td>Bishop simplified</td>" in results.methods._repr_html_() and "factor of safety" in results._repr_html_()
    spencer = results.surfaces["lem.spencer"]
    assert spencer.factor == listed["lem.spencer"] and spencer.points.shape[1] == 2

    axes = talus.plot.plot_surfaces(results, "lem.spencer", "fem.band")
    outline, circle, band = axes.lines
    assert np.allclose(circle.get_xydata(), 100 * spencer.points) and axes.get_xlabel() == "x [cm]"
    assert band.get_linewidth() > circle.get_linewidth() and axes.get_aspect() == 1
    assert f"{spencer.factor:.3f}  Spencer, critical circle" in [t.get_text() for t in axes.get_legend().get_texts()]
    with pytest.raises(talus.InputError, match="there is no surface 'lem.janbu'; there are lem.bishop, lem.spencer"):
        talus.plot.plot_surfaces(results, "lem.janbu")
    pyplot.close("all")

    case.analysis.methods = ["lem"]
    alone = talus.run(case, tmp_path / "slices")
    named = alone.results  # Bishop's is not of all equilibrium
    assert alone.factor_of_safety == min(named["lem.spencer"].value, named["lem.noncircular.spencer"].value)


def find_undescribed(record, data):
    """Names of the JSON that the records do not have."""
    missing = [name for name in data if f"\n{name}: " not in f"\n{record.describe()}"]
    for name, inner in data.items():
        pairs = zip(record[name], inner) if isinstance(inner, list) else [(record[name], inner)]
        missing += [m for own, its in pairs if isinstance(own, talus.Record) for m in find_undescribed(own, its)]
    return missing


def test_records_have_every_name_of_the_summary(results):
    record = results.record
    assert find_undescribed(record, results.summary) == []
    assert record.curve.points[1].displacement == results.summary["curve"]["points"][1]["displacement"]
    assert record.timeline is None and "timeline" in dir(record) and "timeline" not in record
    assert record.to_dict() == results.summary
    assert "slope_height: height of the slope [m]" in record.describe()
    assert pickle.loads(pickle.dumps(record.curve)) == record.curve
    with pytest.raises(AttributeError, match="there is no 'curv' in RunResult; there are bounds, "):
        record.curv
    with pytest.raises(AttributeError, match="results cannot be changed"):
        record.title = "other"
    trial = results.trials[1.4]
    assert trial.record.srf == 1.4 and trial.factor_of_safety is None and trial.methods == []


def test_runs_without_methods_have_no_surfaces(slope, tmp_path):
    results = talus.run(slope(), tmp_path / "run")
    assert results.methods == [] and results.surfaces == {}
    with pytest.raises(talus.InputError, match="there are no slip surfaces"):
        talus.plot.plot_surfaces(results)


@pytest.mark.parametrize("text", ['{"title": "old"}', '{"format": 1}', '{"format": 99}'])
def test_results_of_another_format_are_refused(tmp_path, text):
    (tmp_path / "summary.json").write_text(text)
    with pytest.raises(talus.InputError, match="run the case again"):
        _ = talus.Results(tmp_path).summary
    (tmp_path / "study.json").write_text(text)
    with pytest.raises(talus.InputError, match="run the case again"):
        talus.Study(tmp_path)
