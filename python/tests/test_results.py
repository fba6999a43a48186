"""The arrays are what lies in the files, as h5py and the csv module read them, and no copies."""

import csv
import gc

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
    assert f"{results.factor_of_safety:.2f}  factor of safety" in [t.get_text() for t in axes.get_legend().get_texts()]

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
