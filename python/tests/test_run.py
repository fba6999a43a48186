# SPDX-License-Identifier: MIT
"""A run from Python is the command line's run; it can be stopped and resumed, with bitwise identical results."""

import ctypes
import json
import os
import resource
import select
import signal
import subprocess
import sys

import numpy as np
import pytest

import talus
from conftest import make_slope


def long_slope(slope):
    """About half a second in one stage, so that it can be stopped in the middle."""
    return slope(stage=[dict(name="gravity", duration=60, damping=0.01)], mesh__size=2, output__frame_interval=10)


def test_the_same_bits_as_the_command_line(reduction, tmp_path, command_line):
    case = reduction()
    (tmp_path / "case.toml").write_text(case.to_toml())
    program = command_line("run", tmp_path / "case.toml", "-o", tmp_path / "program", "--threads", 2)
    assert program.returncode == 0, program.stderr
    results = talus.run(case, tmp_path / "python", threads=1)
    theirs = talus.Results(tmp_path / "program")
    assert results.status == "finished"
    assert results.factor_of_safety == theirs.factor_of_safety and 1 < results.factor_of_safety < 3
    assert np.array_equal(results.frame().positions, theirs.frame().positions)
    assert np.array_equal(results.curve.displacement, theirs.curve.displacement)
    assert (tmp_path / "python/history.csv").read_bytes() == (tmp_path / "program/history.csv").read_bytes()
    assert "Coarse slope" in (tmp_path / "python/report.html").read_text()
    assert results.summary["provenance"]["input_hash"] == theirs.summary["provenance"]["input_hash"]


def test_a_device_is_the_one_that_was_asked_for(slope, tmp_path):
    results = talus.run(slope(), tmp_path / "there", device="emulated", threads=2)
    assert results.summary["provenance"]["device"] == "emulated"
    with pytest.raises(talus.InputError, match="expected cpu, gpu, or emulated"):
        talus.run(slope(), tmp_path / "nowhere", device="abacus")
    assert not (tmp_path / "nowhere").exists()


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """The long slope in one piece."""
    return talus.run(long_slope(make_slope), tmp_path_factory.mktemp("whole") / "whole")


@pytest.mark.parametrize("how", ["returning False", "raising"])
def test_stopped_from_the_callback_and_resumed(how, slope, tmp_path, whole):
    case = long_slope(slope)
    seen = []

    def stop(progress):
        seen.append(progress)
        if how == "raising":
            raise RuntimeError("enough")
        return False

    with pytest.raises(talus.Interrupted, match="the state is saved, --resume continues from there") as error:
        talus.run(case, tmp_path / "parts", progress=stop)
    assert error.value.exit_code == 5
    assert (str(error.value.__cause__) == "enough") == (how == "raising")
    assert len(seen) == 1 and seen[0].stage == "gravity" and seen[0].duration == 60
    assert seen[0].fraction == seen[0].time / 60 < 1 and seen[0].line.startswith("gravity: ")
    assert talus.Results(tmp_path / "parts").status == "interrupted"
    assert (tmp_path / "parts/report.html").exists()  # it says how far the run came
    resumed = talus.run(case, tmp_path / "parts", resume=True, report=False)
    assert resumed.status == "finished"
    assert np.array_equal(resumed.frame().positions, whole.frame().positions)
    assert (tmp_path / "parts/history.csv").read_bytes() == (whole.folder / "history.csv").read_bytes()


def test_trials_side_by_side_report_and_stop(reduction, tmp_path):
    case = reduction()
    case.strength_reduction.curve.window = 400  # long enough for a report while a trial runs
    case.strength_reduction.curve.to = 1.6
    case.strength_reduction.frozen.enabled = False
    stages = []

    def watch(progress):
        stages.append((progress.stage, progress.label))
        assert talus.Results(tmp_path / "parts").status == "unknown"  # may look at the folder meanwhile
        return not progress.stage.startswith("trial")

    with pytest.raises(talus.Interrupted):
        talus.run(case, tmp_path / "parts", threads=2, progress=watch)
    assert stages[-1][0].startswith("trial SRF") and stages[-1][1].endswith("of 2]")
    resumed = talus.run(case, tmp_path / "parts", threads=2, resume=True)
    whole = talus.run(case, tmp_path / "whole", threads=1)
    assert np.array_equal(resumed.curve.displacement, whole.curve.displacement)


CHILD = """
import sys, talus
case = talus.Case.read(sys.argv[1])
try:
    talus.run(case, sys.argv[2], progress=lambda p: print("running", flush=True) if sys.argv[3] == "callback" else None)
except KeyboardInterrupt as error:
    print("KeyboardInterrupt caused by", repr(error.__cause__), flush=True)
    sys.exit(7)
"""


def wait_for_file(path, process):
    """Waits until the file is there, or the process has ended; the kernel tells of changes in the folder."""
    path.parent.mkdir(exist_ok=True)
    libc = ctypes.CDLL(None)
    changes, end = libc.inotify_init(), os.pidfd_open(process.pid)
    try:
        libc.inotify_add_watch(changes, bytes(path.parent), 0x100 | 0x80)  # IN_CREATE, IN_MOVED_TO
        while not path.exists() and end not in (ready := select.select([changes, end], [], [])[0]):
            os.read(ready[0], 4096)
    finally:
        os.close(changes)
        os.close(end)


@pytest.mark.parametrize("mode", ["callback", "no callback"])
def test_ctrl_c_leaves_a_folder_that_can_be_resumed(mode, slope, tmp_path):
    case = long_slope(slope)
    case.stage[0].duration = 600  # seconds of wall time
    (tmp_path / "case.toml").write_text(case.to_toml())
    child = subprocess.Popen(
        [sys.executable, "-c", CHILD, tmp_path / "case.toml", tmp_path / "parts", mode],
        stdout=subprocess.PIPE,
        text=True,
    )
    try:
        wait_for_file(tmp_path / "parts/history.csv", child)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        child.send_signal(signal.SIGINT)
        output = child.communicate()[0]
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        assert after.ru_utime - before.ru_utime < 20  # of the process, all in all: a busy machine is only slower
    finally:
        child.kill()
    assert child.returncode == 7, output
    assert "caused by Interrupted(\"interrupted in 'gravity' at t = " in output
    reached = json.loads((tmp_path / "parts/summary.json").read_text())
    assert reached["status"] == "interrupted" and (tmp_path / "parts/checkpoint.h5").exists()
    with pytest.raises(talus.Interrupted) as again:  # it continues from there and can be stopped again
        talus.run(case, tmp_path / "parts", resume=True, progress=lambda p: False)
    before, after = (float(text.split("t = ")[1].split()[0]) for text in (output, str(again.value)))
    assert after >= before


def test_one_run_at_a_time_and_the_next_is_not_stopped(slope, tmp_path):
    sentences = []

    def start_another(progress):
        with pytest.raises(talus.InputError) as error:
            talus.run(slope(), tmp_path / "second")
        sentences.append(str(error.value))
        return False

    with pytest.raises(talus.Interrupted):
        talus.run(long_slope(slope), tmp_path / "first", progress=start_another)
    assert "a process each" in sentences[0]
    assert talus.run(slope(), tmp_path / "second").status == "finished"


def test_errors_have_the_command_lines_sentence_and_code(slope, tmp_path, command_line):
    case = slope()
    (tmp_path / "case.toml").write_text(case.to_toml())
    folder = tmp_path / "results"
    talus.run(case, folder)
    other = slope(mesh__size=2.5)
    (tmp_path / "other.toml").write_text(other.to_toml())
    for error, arguments, words in [
        (talus.FolderExists, dict(case=case), ["case.toml"]),
        (talus.InputError, dict(case=other, resume=True), ["other.toml", "--resume"]),
    ]:
        program = command_line("run", tmp_path / words[0], "-o", folder, *words[1:])
        with pytest.raises(error) as raised:
            talus.run(folder=folder, **arguments)
        assert program.returncode == raised.value.exit_code == error.exit_code
        assert program.stderr == f"talus: error: {raised.value}\n"
    assert talus.run(case, folder, overwrite=True).status == "finished"
    if os.geteuid() != 0:
        os.chmod(tmp_path, 0o555)
        with pytest.raises(talus.CannotWrite):
            talus.run(case, tmp_path / "new")
        os.chmod(tmp_path, 0o755)
    with pytest.raises(talus.CannotWrite, match="/proc"):
        talus.run(case, "/proc/talus")
    with pytest.raises(talus.InputError, match="on = 'roof'|'roof'"):
        slope(boundary__left__on="roof").validate()
    with pytest.raises(ValueError, match="exclude"):
        talus.run(case, folder, resume=True, overwrite=True)


def test_importing_leaves_the_environment_alone():
    code = "import os; before = dict(os.environ); import talus; assert dict(os.environ) == before"
    environment = {k: v for k, v in os.environ.items() if not k.startswith(("OMP_", "GOMP_"))}
    subprocess.run([sys.executable, "-c", code], check=True, env=environment)
