# SPDX-License-Identifier: MIT
"""A study on workers is bitwise identical to the study in one process, whatever happens to the workers."""

import concurrent.futures
import contextlib
import os
import pickle
import random
import signal
import subprocess
import sys

import pytest

import talus
from conftest import make_uncertain

WORKERS = 4


@pytest.fixture(scope="module")
def alone(tmp_path_factory):
    """The study in one process."""
    return talus.study(make_uncertain(400), tmp_path_factory.mktemp("alone") / "study", report=False)


def check_same(study, alone):
    assert (study.folder / "samples.csv").read_bytes() == (alone.folder / "samples.csv").read_bytes()
    ours, theirs = dict(study.sampling), dict(alone.sampling)
    del ours["seconds"], theirs["seconds"]
    assert ours == theirs
    assert len(study.samples["factor of safety"]) == 400


def test_samples_on_processes_have_the_bits_of_one_process(tmp_path, alone):
    lines = []
    with concurrent.futures.ProcessPoolExecutor(WORKERS) as pool:
        study = talus.study(make_uncertain(400), tmp_path / "s", executor=pool, jobs=9, progress=lambda p: lines.append(p.line))
    check_same(study, alone)
    assert lines[-1].startswith("9 of 9 jobs ended")
    assert (tmp_path / "s/report.html").exists() and "400 samples" in repr(study)


def test_threads_of_one_process_take_turns(tmp_path, alone):
    with concurrent.futures.ThreadPoolExecutor(WORKERS) as pool:
        check_same(talus.study(make_uncertain(400), tmp_path / "s", executor=pool, report=False), alone)


def kill_one(pool, draw):
    """Kills a worker of the pool in the middle of what it does."""
    workers = list(pool._processes.values())
    if workers:
        draw.choice(workers).kill()


def test_workers_killed_at_random_lose_nothing(tmp_path, alone, command_line):
    file, folder = tmp_path / "case.toml", tmp_path / "s"
    file.write_text(make_uncertain(400).to_toml())
    assert command_line("study", file, "--prepare", folder, "--jobs", 40).returncode == 0
    draw, broken = random.Random(21), 0
    for turn in range(100):
        with concurrent.futures.ProcessPoolExecutor(WORKERS) as pool:
            if held := turn < 3:  # a job that never comes to its end: the kill is in the middle, however fast the others are
                place = folder / f"jobs/{39 - turn}"
                place.mkdir(exist_ok=True)
                os.mkfifo(place / "result.json.part")
            watch = lambda progress: kill_one(pool, draw) if held or draw.random() < 0.1 else None  # noqa: E731
            try:
                study = talus.study(file, folder, executor=pool, jobs=40, resume=True, progress=watch, report=False)
                break
            except talus.Interrupted as error:
                broken += 1
                assert "jobs" in str(error) and isinstance(error.__cause__, concurrent.futures.BrokenExecutor)
                assert not (folder / "study.json").exists()
        if held:
            (place / "result.json.part").unlink()
    check_same(study, alone)
    assert broken >= 3


def test_jobs_of_the_command_line_killed_in_the_middle_lose_nothing(tmp_path, alone, command_line):
    (tmp_path / "case.toml").write_text(make_uncertain(400).to_toml())
    folder = tmp_path / "s"
    assert command_line("study", tmp_path / "case.toml", "--prepare", folder, "--jobs", 10).returncode == 0
    draw, killed = random.Random(21), 0
    waiting, running = list(range(10)), []
    while waiting or running:
        while waiting and len(running) < WORKERS:
            job, place = waiting.pop(0), None
            if draw.random() < 0.4 or killed < 3:
                place = folder / f"jobs/{job}"
            words = [os.environ["TALUS_PROGRAM"], "study", str(folder), "--job", str(job), "--threads", "1", "-q"]
            running.append((job, place, subprocess.Popen(words)))
        job, place, process = running.pop(draw.randrange(len(running)))
        if place is None:
            assert process.wait() == 0
            continue
        while not (place / "talus.lock").exists() and process.poll() is None:
            pass
        process.kill()
        if process.wait() == -signal.SIGKILL:
            killed += 1
        else:  # it has ended before: once more
            (place / "result.json").unlink()
        waiting.append(job)
    assert killed >= 3
    assert command_line("study", folder, "--collect").returncode == 0
    check_same(talus.Study(folder), alone)


class Unreliable(concurrent.futures.Executor):
    """Loses a job the first times that it is given it, as an executor that replaces its workers does."""

    def __init__(self, losses):
        self.losses, self.given = losses, []

    def submit(self, function, /, *arguments, **more):
        future = concurrent.futures.Future()
        pickle.loads(pickle.dumps((function, arguments, more)))
        self.given.append(arguments[1])
        if self.given.count(arguments[1]) <= self.losses:
            future.set_exception(RuntimeError("the worker was lost"))
        else:
            future.set_result(function(*arguments, **more))
        return future


def test_lost_jobs_are_given_away_again_a_few_times(tmp_path, alone):
    patient = Unreliable(losses=2)
    check_same(talus.study(make_uncertain(400), tmp_path / "a", executor=patient, jobs=2, report=False), alone)
    assert sorted(patient.given) == [0, 0, 0, 1, 1, 1]
    hopeless = Unreliable(losses=3)
    with pytest.raises(talus.Interrupted, match="none of the 2 jobs has ended") as error:
        talus.study(make_uncertain(400), tmp_path / "b", executor=hopeless, jobs=2, report=False)
    assert str(error.value.__cause__) == "the worker was lost"


def test_variants_on_workers_are_those_of_one_process_and_failures_are_repeated(slope, tmp_path):
    # Under a hundred million g the first steps are faster than any wave.
    case = slope(stage=[dict(name="gravity", duration=1)])
    values = {"gravity.acceleration": [9.0, 1e9, 8.0]}
    with pytest.raises(talus.Unstable):
        talus.study(case, tmp_path / "alone", values, report=False)
    with concurrent.futures.ProcessPoolExecutor(2) as pool:
        with pytest.raises(talus.Unstable, match="1 of 4 variants did not finish"):
            talus.study(case, tmp_path / "jobs", values, executor=pool)
        study, alone = talus.Study(tmp_path / "jobs"), talus.Study(tmp_path / "alone")
        assert study.statuses == alone.statuses and study.reasons.keys() == alone.reasons.keys()
        for name in set(alone.table) - {"wall time"}:
            assert study.table[name].tolist() == pytest.approx(alone.table[name].tolist(), rel=0, abs=0, nan_ok=True) or (
                study.table[name].dtype.kind == "U" and study.table[name].tolist() == alone.table[name].tolist()
            ), name
        results = [tmp_path / f"jobs/jobs/{job}/result.json" for job in range(4)]
        times = [result.stat().st_mtime_ns for result in results]
        with pytest.raises(talus.Unstable, match="sbatch --array=2 jobs.slurm"):
            talus.study(case, tmp_path / "jobs", values, executor=pool, resume=True)
        assert [result.stat().st_mtime_ns != time for result, time in zip(results, times)] == [False, False, True, False]


def test_a_stopped_study_goes_on(tmp_path, alone):
    with concurrent.futures.ProcessPoolExecutor(1) as pool:
        with pytest.raises(talus.Interrupted, match="resume=True continues"):
            talus.study(make_uncertain(400), tmp_path / "s", executor=pool, jobs=9, progress=lambda p: False, report=False)
    # At its end the pool has waited for the jobs that were under way.
    with concurrent.futures.ProcessPoolExecutor(1) as pool:
        with pytest.raises(talus.FolderExists, match="is not empty"):
            talus.study(make_uncertain(400), tmp_path / "s", executor=pool)
        with pytest.raises(talus.InputError, match="holds the jobs of another"):
            talus.study(make_uncertain(300), tmp_path / "s", executor=pool, resume=True)
        with pytest.raises(talus.InputError, match="holds the jobs of another"):
            talus.study(make_uncertain(400), tmp_path / "s", executor=pool, jobs=8, resume=True)
        lines = []
        study = talus.study(
            make_uncertain(400), tmp_path / "s", executor=pool, jobs=9, resume=True, progress=lambda p: lines.append(p.line)
        )
        check_same(study, alone)
        assert not any(" of 9 jobs" in line for line in lines)  # the first one was kept
    with pytest.raises(ValueError, match="belong to an executor"):
        talus.study(make_uncertain(400), tmp_path / "never", jobs=3)


def test_mpi_futures_have_the_same_bits(tmp_path, alone):
    pytest.importorskip("mpi4py", reason="there is no mpi4py (tools/apt-packages-cluster.txt): jobs on MPI ranks were NOT tried")
    script = tmp_path / "on_ranks.py"
    script.write_text(
        "import sys\n"
        "from mpi4py.futures import MPIPoolExecutor\n"
        "import talus\n"
        "if __name__ == '__main__':\n"
        "    with MPIPoolExecutor() as pool:\n"
        "        talus.study(sys.argv[1], sys.argv[2], executor=pool, jobs=9, report=False)\n"
    )
    (tmp_path / "case.toml").write_text(make_uncertain(400).to_toml())
    words = ["mpiexec", "--allow-run-as-root", "--oversubscribe", "-n", str(WORKERS + 1)]
    words += [sys.executable, "-m", "mpi4py.futures", str(script), str(tmp_path / "case.toml"), str(tmp_path / "s")]
    environment = {**os.environ, "OMPI_MCA_rmaps_base_oversubscribe": "1"}
    ended = subprocess.run(words, capture_output=True, text=True, env=environment)
    assert ended.returncode == 0, ended.stderr
    check_same(talus.Study(tmp_path / "s"), alone)


def test_dask_replaces_a_killed_worker_and_has_the_same_bits(tmp_path, alone):
    distributed = pytest.importorskip(
        "distributed", reason="there is no Dask (tools/apt-packages-cluster.txt): jobs on its workers were NOT tried"
    )
    with distributed.LocalCluster(
        n_workers=WORKERS, threads_per_worker=1, dashboard_address=":0", local_directory=str(tmp_path / "dask")
    ) as cluster, distributed.Client(cluster) as client:
        draw = random.Random(21)
        left = [2]

        def watch(progress):
            if left[0] > 0:
                left[0] -= 1
                with contextlib.suppress(ProcessLookupError):  # one that is being replaced
                    os.kill(draw.choice([nanny.pid for nanny in cluster.workers.values() if nanny.pid]), signal.SIGKILL)

        study = talus.study(
            make_uncertain(400), tmp_path / "s", executor=client.get_executor(), jobs=20, progress=watch, report=False
        )
    check_same(study, alone)
