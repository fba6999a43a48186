# SPDX-License-Identifier: MIT
"""Runs side by side in processes, results sent between them, and memory that does not grow."""

import gc
import multiprocessing
import os
import pathlib
import pickle
import shutil
import subprocess
import sys
import threading
from concurrent.futures import ProcessPoolExecutor

import numpy as np
import pytest

import talus


def calculate(cohesion, folder):
    from conftest import make_slope

    case = make_slope(materials__sand__cohesion=cohesion, stage=[dict(name="gravity", duration=2)])
    return talus.run(case, f"{folder}/{cohesion}", threads=2)


@pytest.mark.parametrize("start", ["fork", "spawn"])
def test_a_sweep_in_processes_is_the_sweep_in_a_loop(start, tmp_path):
    # The parent has calculated, drawn up reports and read before it forks: none of its threads is in the child.
    alone = {cohesion: calculate(cohesion, tmp_path / "loop") for cohesion in (2.0, 200.0)}
    assert len(alone[2.0].frame()) > 0
    with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context(start)) as pool:
        jobs = {cohesion: pool.submit(calculate, cohesion, tmp_path / "pool") for cohesion in alone}
        try:
            sent = {cohesion: job.result(timeout=240) for cohesion, job in jobs.items()}
        except BaseException:
            for process in list(pool._processes.values()):
                process.kill()  # or the pool would wait for them for ever
            raise
    for cohesion, results in alone.items():
        assert sent[cohesion].folder == tmp_path / "pool" / str(cohesion)
        assert np.array_equal(sent[cohesion].frame().positions, results.frame().positions)
    assert not np.array_equal(alone[2.0].frame().positions, alone[200.0].frame().positions)


def test_results_and_frames_can_be_sent(tmp_path):
    results = calculate(2.0, tmp_path)
    frame = results.frame()
    for object_, get in [(results, lambda r: r.frame().positions), (frame, lambda f: f.positions)]:
        assert np.array_equal(get(pickle.loads(pickle.dumps(object_))), frame.positions)
    history = pickle.loads(pickle.dumps(results.history))
    assert np.array_equal(history["time"], results.history["time"]) and history.units == results.history.units


def get_memory():
    """Memory in use [bytes]."""
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def test_reading_frames_in_a_loop_does_not_grow(tmp_path, slope):
    case = slope(mesh__size=0.75, stage=[dict(name="gravity", duration=0.1)])
    results = talus.run(case, tmp_path / "run", report=False)
    size = sum(values.nbytes for values in results.frame().fields.values())

    def read(times):
        for _ in range(times):
            results.frame().field("stress").sum()
        gc.collect()
        return get_memory()

    first, last = read(30), read(200)
    assert last - first < 20 * size  # 200 frames would be 200 times the size


def test_a_second_run_in_another_thread_is_refused_and_does_not_disturb(slope, tmp_path):
    case = slope(stage=[dict(name="gravity", duration=30, damping=0.01)], mesh__size=2)
    refused = []

    def try_another():
        try:
            talus.run(slope(), tmp_path / "second")
        except talus.InputError as error:
            refused.append(str(error))

    def watch(progress):
        if not refused:
            other = threading.Thread(target=try_another)
            other.start()
            while other.is_alive():
                other.join(0.01)

    first = talus.run(case, tmp_path / "first", progress=watch)
    assert first.status == "finished" and "a process each" in refused[0]
    assert not (tmp_path / "second").exists()


def test_a_run_from_another_thread_and_one_after_a_failed_callback(slope, tmp_path):
    done = []
    thread = threading.Thread(target=lambda: done.append(talus.run(slope(), tmp_path / "thread")))
    thread.start()
    thread.join()
    assert done[0].status == "finished"
    with pytest.raises(TypeError, match="must be a function"):
        talus.run(slope(), tmp_path / "never", progress=3)
    with pytest.raises(TypeError, match="integer"):
        talus.run(slope(), tmp_path / "never", threads=1.5)
    assert not (tmp_path / "never").exists()


def import_from(folder, **environment):
    """What Python says to `import talus` where the package is in this folder."""
    environment = {**os.environ, "PYTHONPATH": str(folder), **environment}
    return subprocess.run([sys.executable, "-c", "import talus"], capture_output=True, text=True, env=environment).stderr


def test_a_package_without_its_compiled_part_says_so(tmp_path):
    package = pathlib.Path(talus.__file__).parent
    shutil.copytree(package, tmp_path / "talus", ignore=shutil.ignore_patterns("_core.*", "__pycache__"))
    assert f"the compiled part of talus is not in {tmp_path / 'talus'}: `make program`" in import_from(tmp_path)


def test_a_level_that_is_not_there_is_refused():
    said = import_from(pathlib.Path(talus.__file__).parent.parent, TALUS_LEVEL="x86-64-v1")
    assert "TALUS_LEVEL is 'x86-64-v1', and this package is compiled for " in said
