# SPDX-License-Identifier: MIT
"""Runs of the program, each in its own folder."""
from __future__ import annotations

import json
import pathlib
import re
import subprocess
import time


class Broken(Exception):
    """The program ended with an error; the text is its first sentence."""


class Runner:
    def __init__(self, program, folder, threads=1, keep=False):
        self.program, self.folder, self.threads, self.keep = program, pathlib.Path(folder), threads, keep
        self.folder.mkdir(parents=True, exist_ok=True)
        self.seconds = {}

    def get_folder(self, name):
        return self.folder / re.sub(r"[^\w.=-]", "_", name)

    def run(self, name, text, settings=(), command="run", answer="summary.json"):
        """Writes NAME.toml, runs it into NAME/, and returns its summary (the file `answer`); with `keep` a finished run of the same text is
        taken as it is (settings are told apart by their name)."""
        out = self.get_folder(name)
        case = out.with_name(out.name + ".toml")
        if self.keep and (out / answer).exists() and case.exists() and case.read_text() == text:
            summary = json.loads((out / answer).read_text())
            if summary.get("status", "finished") == "finished":
                return summary
        case.write_text(text)
        words = [self.program, command, str(case), "-o", str(out), "--threads", str(self.threads), "-q", "--overwrite"]
        for setting in settings:
            words += ["--set", setting]
        start = time.perf_counter()
        done = subprocess.run(words, capture_output=True, text=True)
        self.seconds[name] = time.perf_counter() - start
        if done.returncode != 0:
            said = (done.stderr.strip() or done.stdout.strip() or f"ended with {done.returncode}").splitlines()
            raise Broken(" ".join(said).rpartition("error: ")[2][:300])
        return json.loads((out / answer).read_text())
