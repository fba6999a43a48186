# SPDX-License-Identifier: MIT
"""Campaigns over numbered random cases: their command line, their parallel runs, and the reasons for outliers."""
from __future__ import annotations

import argparse
import concurrent.futures
import json
import os
import pathlib
import tempfile

from .runs import Runner


def parse_options(doc, count, written, short=""):
    """`doc`: of the tool; `count`: cases unless told; `written`, `short`: what --write and --short do, in words."""
    parser = argparse.ArgumentParser(description=doc, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=count)
    parser.add_argument("--only", nargs="+", type=int, default=[], metavar="N")
    parser.add_argument("--out", type=pathlib.Path)
    parser.add_argument("--keep", action="store_true", help="take results that are in --out as they are")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--write", action="store_true", help=f"write {written}")
    if short:
        parser.add_argument("--short", action="store_true", help=short)
    return parser.parse_args()


def judge_all(options, judge):
    """judge(runner, number) of every case that was asked for, in their order."""
    with tempfile.TemporaryDirectory() as scratch:
        runner = Runner(os.path.abspath(options.program), options.out or pathlib.Path(scratch), keep=options.keep)
        with concurrent.futures.ThreadPoolExecutor(max(1, options.jobs)) as pool:
            return list(pool.map(lambda n: judge(runner, n), options.only or range(1, options.count + 1)))


def read_reasons(path):
    """Reasons for outliers by the number of the case as text; empty without the file."""
    return json.loads(path.read_text()) if path.exists() else {}


def show(value, form):
    return "–" if value is None else form.format(value)
