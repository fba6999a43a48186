#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The server of the studio over a real socket: who may ask, paths, revisions, journal, runs and their course, comparison, exports,
restarts, hostile requests.

Usage: server.py TALUS [requests]

`requests` is the number of hostile requests (1,000). Nothing waits for a clock: events and answers are awaited.
"""
import base64
import json
import os
import pathlib
import random
import signal
import socket
import subprocess
import sys
import tempfile
import tomllib
import urllib.parse

from requests_and_cases import CASE, LONG, METHODS, STUDY, make_hostile
from server_process import TIMEOUT, Server

DATA = pathlib.Path(__file__).resolve().parent.parent / "data"

faults = []


def has_module(program, name):
    return (pathlib.Path(program).parent / name).exists()


def check(is_good, what):
    if not is_good:
        faults.append(what)
        print("FAILED:", what)


def check_admission(server):
    check(server.ask("GET", "/api/files", token=False)[0] == 401, "no token")
    check(server.ask("GET", "/api/files", headers={"X-Talus-Token": server.token[:-1] + "x"})[0] == 401, "wrong token")
    check(server.ask("GET", "/api/files", headers={"X-Talus-Token": ""})[0] == 401, "empty token")
    check(server.ask("PUT", f"/api/files/slope.toml?token={server.token}", "{}", token=False)[0] == 401, "token in the query of a PUT")
    for host in ("evil.example", f"evil.example:{server.port}", f"127.0.0.1.evil.example:{server.port}", "127.0.0.1", "127.0.0.1:1"):
        check(server.ask("GET", "/api/files", headers={"Host": host})[0] == 403, f"Host {host}")
        check(server.ask("GET", "/", headers={"Host": host})[0] == 403, f"page with Host {host}")
    check(server.ask("GET", "/api/files", headers={"Host": f"localhost:{server.port}"})[0] == 200, "Host localhost")
    for origin in ("http://evil.example", "null", f"https://127.0.0.1:{server.port}", "http://127.0.0.1:1"):
        check(server.ask("POST", "/api/check", CASE, {"Origin": origin})[0] == 403, f"Origin {origin}")
    check(server.ask("POST", "/api/check", CASE, {"Origin": f"http://127.0.0.1:{server.port}"})[0] == 200, "own Origin")
    check(server.ask("GET", "/", token=False)[0] == 200, "the page needs no token")
    policy = server.headers.get("Content-Security-Policy", "")
    check("default-src 'none'" in policy and "frame-ancestors 'none'" in policy, "policy of the page")
    check("'unsafe-eval'" not in policy and "script-src 'self'" in policy, "scripts of the page")
    check(server.headers.get("X-Content-Type-Options") == "nosniff", "nosniff")
    check("Access-Control-Allow-Origin" not in server.headers, "no other page may read")
    check(server.ask("POST", "/", "x")[0] == 405, "POST to a page")
    # Only the loopback address is bound.
    with socket.socket() as other:
        other.bind(("127.0.0.2", server.port))


def check_engine(server):
    status, answer = server.ask("POST", "/api/check", CASE)
    check(status == 200 and answer["messages"] == [] and answer["ready"], f"check: {answer}")
    begin, end = answer["spans"]["materials.clay.cohesion"]
    check(CASE.encode()[begin:end] == b'"10 kPa"', "span of the cohesion in bytes")
    status, answer = server.ask("POST", "/api/check", CASE.replace('"10 kPa"', '"10 kg"'))
    check(answer["messages"][0]["key"] == "materials.clay.cohesion", "key of a message")
    status, answer = server.ask("POST", "/api/solve", {"text": CASE, "options": {"methods": ["bishop"], "circles": 1000}})
    check(status == 200 and 1.3 < answer["factor"] < 1.9, f"solve: {answer.get('factor')}")
    # A table that the case names is beside it.
    table = CASE.replace("[[geometry.polygon]]\nname", "[geometry]\nground = { file = \"ground.csv\" }\n\n[[geometry.layer]]\nlevel = 0\nname").replace(
        "points = [[0, 0], [44, 0], [44, 5], [32, 5], [12, 15], [0, 15]]\n", "")
    check(server.ask("POST", "/api/check?path=inner/other.toml", table)[1]["messages"] == [], "a table beside the case")
    check(server.ask("POST", "/api/check", table)[1]["messages"] != [], "no table in the folder itself")
    check(server.ask("POST", "/api/check?path=../x.toml", table)[0] == 403, "a check outside the folder")
    status, answer = server.ask("POST", "/api/solve", {"text": table, "path": "inner/other.toml", "options": {"circles": 500}})
    check(status == 200 and answer.get("factor"), f"solve with a table: {answer}")
    check("properties" in server.ask("GET", "/api/schema")[1], "schema")
    check("[geometry]" in server.ask("GET", "/api/template")[1]["text"], "template")
    check(server.ask("POST", "/api/solve", "[]")[0] == 400, "solve without an object")
    check(server.ask("POST", "/api/solve", "[" * 100000)[0] == 400, "deep JSON")
    check("error" in server.ask("POST", "/api/solve", {"text": CASE, "options": {"circles": -1}})[1], "negative circles")


def check_files(server, folder):
    listed = server.ask("GET", "/api/files")[1]
    check([f["path"] for f in listed["files"]] == ["inner/other.toml", "slope.toml"], f"files: {listed}")
    status, read = server.ask("GET", "/api/files/slope.toml")
    check(status == 200 and read["text"] == CASE, "read")
    escapes = ["../secret.toml", "..%2Fsecret.toml", "%2e%2e/secret.toml", "inner/../../secret.toml", "/etc/passwd", "%2Fetc%2Fpasswd",
               "link.toml", "linked/secret.toml", ".hidden.toml", ".talus-studio/runs/0001.toml", "inner", "inner/", "notes.txt",
               "a%00.toml", "slope.toml%00.txt", "a%0a.toml", "x" * 300 + ".toml", "/".join(["d"] * 200) + "/a.toml", "pipe.toml", ".", "..", ""]
    for path in escapes:
        for method, body in (("GET", None), ("PUT", {"text": "stolen", "revision": ""})):
            status, answer = server.ask(method, "/api/files/" + path, body)
            check(status in (400, 403, 404) and "error" in answer, f"{method} {path!r}: {status} {answer}")
        check(server.ask("PUT", "/api/journal/" + path, {"text": "x", "revision": ""})[0] in (400, 403, 404), f"journal {path!r}")
        check(server.ask("POST", "/api/runs", {"path": urllib.parse.unquote(path)})[0] in (400, 403, 404), f"run of {path!r}")
    check((folder.parent / "secret.toml").read_text() == "secret", "the file outside is unchanged")
    for path in ("/../secret.toml", "/%2e%2e/secret.toml", "//etc/passwd", "/assets/../../secret.toml", "/.git/config"):
        check(server.ask("GET", path)[0] in (400, 404), f"page {path}")
    # Revisions: two tabs change the file, and the second is told.
    first, second = read["text"] + "# first\n", read["text"] + "# second\n"
    status, saved = server.ask("PUT", "/api/files/slope.toml", {"text": first, "revision": read["revision"]})
    check(status == 200 and (folder / "slope.toml").read_text() == first, "save")
    status, conflict = server.ask("PUT", "/api/files/slope.toml", {"text": second, "revision": read["revision"]})
    check(status == 409 and conflict == {"text": first, "revision": saved["revision"]}, f"conflict: {status} {conflict}")
    check((folder / "slope.toml").read_text() == first, "the first text stays")
    check(server.ask("PUT", "/api/files/slope.toml", {"text": CASE, "revision": saved["revision"]})[0] == 200, "merged")
    check(server.ask("PUT", "/api/files/slope.toml", {"text": "", "revision": ""})[0] == 409, "an existing file is not new")
    check(server.ask("PUT", "/api/files/inner/new.toml", {"text": CASE, "revision": ""})[0] == 200, "new file")
    (folder / "inner/new.toml").unlink()
    check(server.ask("PUT", "/api/files/inner/new.toml", {"text": CASE, "revision": saved["revision"]})[0] == 409, "a file that was removed")
    check(server.ask("PUT", "/api/files/absent/new.toml", {"text": CASE, "revision": ""})[0] == 404, "new folder")
    check(server.ask("PUT", "/api/files/slope.toml", {"text": 5})[0] == 400, "a text that is none")
    # The journal outlives kill -9 of the server. Entries keep the text that they grew from and its revision.
    journal = lambda path="/slope.toml": server.ask("GET", "/api/journal" + path)[1]["entries"]
    keep = lambda path="/slope.toml", **entry: server.ask("PUT", "/api/journal" + path, entry)[0]
    revision = server.ask("GET", "/api/files/slope.toml")[1]["revision"]
    check(journal() == [] and keep(text="typed", revision=revision) == 200, "journal")
    check(keep(window="a1", text="one", base=CASE, revision=revision) == 200 and keep(window="b2", text="two", base=first) == 200, "two windows")
    check({e["window"]: (e["text"], e["base"], e["revision"]) for e in journal()} ==
          {"": ("typed", "", revision), "a1": ("one", CASE, revision), "b2": ("two", first, "")}, f"entries: {journal()}")
    check(server.ask("PUT", "/api/files/slope.toml", {"text": second, "revision": revision})[0] == 200, "a newer file")
    conflict = server.ask("PUT", "/api/files/slope.toml", {"text": "one", "revision": journal()[-1]["revision"]})[1]
    check(conflict["text"] == second and (folder / "slope.toml").read_text() == second, "an entry of an older file does not replace it")
    check(server.ask("PUT", "/api/files/slope.toml", {"text": "two", "revision": conflict["revision"]})[0] == 200, "the text of an entry is saved")
    check(sorted(e["window"] for e in journal()) == ["", "a1"], "its entry is removed")
    check([keep(window="a1", text=None) for _ in range(2)] == [200, 200] and [e["text"] for e in journal()] == ["typed"], "an entry is removed")
    check({keep(window=name, text="x") for name in ("../a", "A", "a/b", "x" * 33, "a.json", "\u00e9", 5)} == {400}, "names of windows")
    check(keep("", window="n1", text="drawn") == 200 and [[e["text"] for e in journal(path)] for path in ("", "/slope.toml", "/inner/other.toml")]
          == [["drawn"], ["typed"], []], "a case that was never saved")
    (folder / "slope.toml").write_text(CASE)


def check_imports(server, folder):
    def give(*names, **options):
        files = [{"name": pathlib.Path(name).name, "data": base64.b64encode((DATA / name).read_bytes()).decode()} for name in names]
        return server.ask("POST", "/api/import", {"files": files, "options": options})

    status, answer = give("tables/own_slope_surface.csv")
    check(status == 400 and "--base" in answer["error"], f"a ground with nothing below it: {answer}")
    status, answer = give("tables/own_slope_surface.csv", base="-20")
    points = tomllib.loads(answer["text"])["geometry"]["ground"] if status == 200 else []
    rows = [[float(cell) for cell in row.split(",")] for row in (DATA / "tables/own_slope_surface.csv").read_text().split()[1:]]
    check(status == 200 and len(rows) == 60 and points == rows, f"60 points of a survey: {status} {answer}")
    check(any("strengths and weights" in remark for remark in answer.get("remarks", [])), f"remarks: {answer}")
    status, answer = give("tables/own_slope_surface.csv", "tables/own_slope_base.csv", base="-20")
    check(status == 200 and len(tomllib.loads(answer["text"])["geometry"]["layer"]) == 2, f"two tables: {answer}")
    # The program itself gives the same text.
    with tempfile.TemporaryDirectory() as name:
        for file, options in (("drawings/geotechstaff_sample_section.dxf", {"units": "ft"}), ("drawings/hand_written_cut.geojson", {})):
            more = [f"--{key}={value}" for key, value in options.items()]
            done = subprocess.run([server.program, "import", DATA / file, "-o", f"{name}/case.toml", "--overwrite", *more], capture_output=True, text=True)
            status, answer = give(file, **options)
            if not has_module(server.program, "libtalus_gdal.so"):
                check(status == 400 and "has no GDAL" in answer["error"] and "make program" in answer["error"], f"{file} without GDAL: {answer}")
            elif done.returncode:
                check(status == 400 and answer["error"].split("'")[-1] == done.stderr.strip().split("'")[-1], f"{file}: {answer} {done.stderr}")
            else:
                check(status == 200 and answer["text"] == pathlib.Path(f"{name}/case.toml").read_text(), f"{file}: {answer}")
    status, answer = give("tables/pygslib_collar.csv")
    check(status == 400 and str(folder) not in answer["error"], f"a table of collars alone: {answer}")
    table = base64.b64encode(b"x,y\n0,5\n10,1\n").decode()
    hostile = [{"name": name, "data": table} for name in ("../a.csv", "/etc/a.csv", ".a.csv", "a.toml", "a.sh", "a\0.csv", "", "a/b.csv", "x" * 300 + ".csv", "a\n.csv")]
    for file in [*hostile, {"name": "a.csv", "data": "!!!!"}, {"name": "a.csv", "data": "abc"}, {"name": "a.csv", "data": "=abc"}, {"name": "a.csv"}, 5, None]:
        status, answer = server.ask("POST", "/api/import", {"files": [file]})
        check(status == 400 and "error" in answer, f"import of {file}: {status} {answer}")
    good = {"name": "-o.csv", "data": table}
    check(server.ask("POST", "/api/import", {"files": [good], "options": {"base": "-5"}})[0] == 200, "a name like an option")
    check(server.ask("POST", "/api/import", {"files": [good, good]})[0] == 400, "two files of one name")
    check(server.ask("POST", "/api/import", {"files": [good] * 30})[0] == 400, "30 files")
    for options in ({"output": "x"}, {"overwrite": ""}, {"units": 5}, {"units": "m" * 400}, {"layers": "a"}, {"layers": [5]}, "--overwrite", {"base": "$(touch hacked)"}):
        check(server.ask("POST", "/api/import", {"files": [good], "options": options})[0] == 400, f"options {options}")
    check(server.ask("POST", "/api/import", "[" * 100000)[0] == 400, "deep JSON of an import")
    check(not list((folder / ".talus-studio/imports").iterdir()), "dropped files are removed")
    check(not (folder / "hacked").exists(), "no shell")


def check_asides(server, folder):
    check(server.ask("GET", "/api/aside/library")[1] is None, "no note")
    check(server.ask("PUT", "/api/aside/library", {"a": [1]})[0] == 200 and server.ask("GET", "/api/aside/library")[1] == {"a": [1]}, "a note")
    check(server.ask("PUT", "/api/aside/../../slope.toml", "{}")[0] in (200, 400, 404) and (folder / "slope.toml").read_text() == CASE, "the name of a note is no path")
    for body in ("", "{", "[" * 100000):
        check(server.ask("PUT", "/api/aside/library", body)[0] == 400, f"a note {body[:5]!r}")
    check(server.ask("PUT", "/api/aside/library", "null")[0] == 200 and server.ask("GET", "/api/aside/library")[1] is None, "a note is removed")
    check(server.ask("GET", "/api/aside/" + "x" * 2000)[0] == 404, "a long name of a note")


def check_report_data(server, folder, program, run, hostile):
    """The data are those of the command, and are sent once; the page for them is in a sandbox."""
    status, report = server.ask("GET", f"/api/runs/{run}/report-data")
    with tempfile.TemporaryDirectory() as name:
        subprocess.run([program, "report", folder / "studio_runs" / run, "--data", f"{name}/data.json"], check=True)
        data = json.loads(pathlib.Path(f"{name}/data.json").read_text())
    check(status == 200 and not report["active"] and report["data"] == data, f"data of a report: {status}")
    known = server.ask("GET", f"/api/runs/{run}/report-data?known={report['stamp']}")[1]
    check(known == {"active": False, "stamp": report["stamp"]}, f"data that are known: {known}")
    check("no results" in server.ask("GET", f"/api/runs/{hostile}/report-data")[1]["why"], "no data of a failed run")
    for name in ("9999", "../0001", "x"):
        check(server.ask("GET", f"/api/runs/{name}/report-data")[0] == 404, f"data of run {name!r}")
    check(server.ask("GET", f"/api/runs/{run}/report-data", token=False)[0] == 401, "the data need the token")
    status, page = server.ask("GET", "/report.html", token=False)
    check(status == 200 and b"talus-results" in page and server.headers["Content-Security-Policy"].startswith("sandbox"), "the page of the reports")


def check_runs(server, folder, program):
    check(server.ask("POST", "/api/runs", {"path": "absent.toml"})[0] == 404, "run of an absent file")
    check(server.ask("POST", "/api/runs", {"path": "slope.toml", "settings": {"threads": 0}})[0] == 400, "no threads")
    check(server.ask("POST", "/api/runs", {"path": "slope.toml", "settings": {"set": {"a=b": 1}}})[0] == 400, "a key with =")
    # A shell would execute this value; the case refuses it.
    status, hostile = server.ask("POST", "/api/runs", {"path": "slope.toml", "settings": {"set": {"title;touch hacked": "$(touch hacked)"}}})
    status, run = server.ask("POST", "/api/runs", {"path": "slope.toml", "settings": {"set": {"materials.clay.cohesion": "12 kPa"}, "threads": 1}})
    check(status == 200, f"run: {run}")
    check(server.watch(hostile["id"])[-1][1]["state"] == "failed" and not (folder / "hacked").exists(), "a hostile setting")
    events = server.watch(run["id"])
    kind, last = events[-1]
    check(kind == "done" and last["state"] == "done", f"end of a run: {last}")
    text = CASE.replace('"10 kPa"', '"12 kPa"')
    solved = server.ask("POST", "/api/solve", {"text": text})[1]
    check(last["factor"] == solved["factor"], f"the run has {last['factor']}, the engine {solved['factor']}")
    status, report = server.ask("GET", f"/api/runs/{run['id']}/report?token={server.token}", token=False)
    check(status == 200 and b"<html" in report, "report")
    check(server.headers["Content-Security-Policy"].startswith("sandbox"), "the report is in a sandbox")
    check(server.ask("GET", f"/api/runs/{hostile['id']}/report")[0] == 404, "no report of a failed run")
    check_report_data(server, folder, program, run["id"], hostile["id"])
    for name in ("9999", "../0001", "0001%2f..", "x", ""):
        check(server.ask("POST", f"/api/runs/{name}/stop")[0] == 404, f"run {name!r}")
    check([r["state"] for r in server.ask("GET", "/api/runs")[1]["runs"]] == ["done", "failed"], "list of runs")
    check(not list(folder.glob(".slope-0002*")), "the copy of the text is removed")


def list_values(events, method):
    return [data for kind, data in events if kind == "value" and data["method"] == method]


def check_course(events, results):
    """Values of a run in progress against its results."""
    lem, fem, bounds = (list_values(events, method) for method in ("lem", "fem", "bounds"))
    check(len(lem) == 1 and abs(lem[0]["factor"] - results["lem.bishop"]) < 1e-12 and len(lem[0]["surface"]) > 2, f"LEM: {lem}")
    trials = [v for v in fem if "holds" in v]
    check(len(trials) >= 3, f"trials of FEM: {fem}")
    for before, after in zip(trials, trials[1:]):
        check(after.get("lower", 0) >= before.get("lower", 0) and after.get("upper", 1e9) <= before.get("upper", 1e9), "the bracket of FEM narrows")
    check(all(v["lower"] >= v["factor"] if v["holds"] else v["upper"] <= v["factor"] for v in trials), "a trial is within the bracket")
    found = [v for v in fem if "factor" in v and "holds" not in v]
    check(len(found) == 1 and abs(found[0]["factor"] - results["fem.factor"]) < 1e-12, f"the factor of FEM: {found}")
    check(trials[-1]["lower"] <= found[0]["factor"] <= trials[-1]["upper"], "the factor of FEM is in its bracket")
    check(bounds and bounds[-1]["lower"] == results["bounds.lower"] and bounds[-1]["upper"] == results["bounds.upper"], f"limit analysis: {bounds}")
    progress = [data for kind, data in events if kind == "progress"]
    check(progress and all(isinstance(data.get("line", ""), str) for data in progress), "lines of progress")


def read_summary(folder, run):
    return json.loads((folder / "studio_runs" / run / "summary.json").read_text())


def check_results(server, folder, program):
    """Live values, results, comparison and exports of two runs."""
    (folder / "methods.toml").write_text(METHODS, encoding="utf-8")
    first = server.ask("POST", "/api/runs", {"path": "methods.toml"})[1]["id"]
    second = server.ask("POST", "/api/runs", {"path": "methods.toml", "settings": {"set": {"materials.clay.cohesion": "14 kPa"}}})[1]["id"]
    events = server.watch(first)
    check(events[-1][1]["state"] == "done", f"all methods: {events[-1]}")
    stored = {r["name"]: r["value"] for r in read_summary(folder, first)["results"]}
    check_course(events, stored)
    again = server.watch(first)
    check([e for e in again if e[0] == "value"] == [e for e in events if e[0] == "value"], "a later window sees the same course")
    status, listed = server.ask("GET", f"/api/runs/{first}/values")
    check(status == 200 and {v["name"] for v in listed["values"]} == set(stored), "results of a run")
    check({s["method"] for s in listed["surfaces"]} >= {"lem", "fem"} and all(len(s["points"]) > 1 for s in listed["surfaces"]), "surfaces of a run")
    check(server.watch(second)[-1][1]["state"] == "done", "the second run")
    status, compared = server.ask("GET", f"/api/compare?first={first}&second={second}")
    check(status == 200 and [k["key"] for k in compared["inputs"]] == ["materials.clay.cohesion"], f"keys that differ: {compared.get('inputs')}")
    check([float(compared["inputs"][0][side]) for side in ("first", "second")] == [10, 14], f"their values: {compared['inputs']}")
    other = {r["name"]: r["value"] for r in read_summary(folder, second)["results"]}
    check({v["name"] for v in compared["values"]} == set(stored) | set(other), "all results are compared")
    for value in compared["values"]:
        if value["name"] in stored and value["name"] in other and value["unit"] in ("", "1"):
            difference = other[value["name"]] - stored[value["name"]]
            check(value["difference"] == difference and abs(value["relative"] * stored[value["name"]] - difference) < 1e-12, f"difference: {value}")
    factor = next(v for v in compared["values"] if v["name"] == "lem.factor")
    check(factor["difference"] > 0.05 and compared["warnings"] == [], f"more cohesion, larger factor: {factor} {compared['warnings']}")
    same = server.ask("GET", f"/api/compare?first={first}&second={first}")[1]
    check(same["inputs"] == [] and all(v["difference"] == 0 for v in same["values"]), "a run equals itself")
    check(server.ask("GET", f"/api/compare?first={first}&second=9999")[0] == 404, "comparison with an absent run")
    check_exports(server, folder, program, first)


def check_exports(server, folder, program, run):
    for name, module, begin in (("dxf", "libtalus_gdal.so", b"  0\nSECTION"), ("xlsx", "libtalus_xlsx.so", b"PK")):
        status, data = server.ask("GET", f"/api/runs/{run}/export.{name}?token={server.token}", token=False)
        if has_module(program, module):
            check(status == 200 and data.startswith(begin), f"{name}: {status} {data[:80]!r}")
            check("attachment" in server.headers.get("Content-Disposition", ""), f"{name} is a download")
        else:
            check(status == 400 and "make program" in data["error"], f"{name} without its module: {status} {data}")
    check(server.ask("GET", f"/api/runs/{run}/export.svg")[0] == 404, "another format")
    check(server.ask("GET", f"/api/runs/{run}/export.dxf", token=False)[0] == 401, "an export needs the token")
    if has_module(program, "libtalus_gdal.so"):
        status, data = server.ask("POST", "/api/export", {"text": CASE, "path": "slope.toml"})
        check(status == 200 and b"ENTITIES" in data, f"DXF of a text: {status} {data[:80]!r}")
        status, answer = server.ask("POST", "/api/export", {"text": CASE.replace("unit_weight = 20", "")})
        check(status == 400 and "unit_weight" in answer["error"], f"DXF of a faulty text: {status} {answer}")
    check(server.ask("POST", "/api/export", {"text": CASE, "path": "../x.toml"})[0] == 403, "an export outside the folder")
    check(not list(folder.glob(".*export*")) and not list((folder / ".talus-studio/exports").iterdir()), "no scratch file stays")


def check_method_checks(server, folder, program):
    """The checks of methods are those of `talus check`."""
    check(server.ask("POST", "/api/check-methods", METHODS)[1] == {"messages": []}, "methods without faults")
    wrong = METHODS.replace("gap = 0.15", "gap = 0.15\nsize = 0.02\ntriangles = 1000")
    check(server.ask("POST", "/api/check", wrong)[1]["messages"] == [], "the quick check does not see the number of triangles")
    status, answer = server.ask("POST", "/api/check-methods", wrong)
    (folder / "wrong.toml").write_text(wrong, encoding="utf-8")
    told = subprocess.run([program, "check", str(folder / "wrong.toml")], capture_output=True, text=True).stderr
    (folder / "wrong.toml").unlink()
    check(len(answer["messages"]) == 1 and answer["messages"][0]["text"] in told, f"{answer} and {told!r}")
    check(server.ask("POST", "/api/check-methods", "x = [")[1] == {"messages": []}, "a text with faults has its messages elsewhere")
    check(server.ask("POST", "/api/check-methods?path=../x.toml", CASE)[0] == 403, "a method check outside the folder")


def check_study_and_frames(server, folder):
    (folder / "study.toml").write_text(STUDY, encoding="utf-8")
    check(server.ask("POST", "/api/runs", {"path": "study.toml", "settings": {"study": 1}})[0] == 400, "study = 1")
    study = server.ask("POST", "/api/runs", {"path": "study.toml", "settings": {"study": True}})[1]["id"]
    events = server.watch(study)
    check(events[-1][1]["state"] == "done", f"a study: {events[-1]}")
    rows = list_values(events, "study")
    check(sorted(v["done"] for v in rows) == [1, 2, 3] and all(v["total"] == 3 for v in rows), f"variants: {rows}")
    factors = {v["series"]: v["factor"] for v in rows}
    check(factors["cohesion = 8 kPa"] < factors["base"] < factors["cohesion = 12 kPa"], f"the factor follows the cohesion: {rows}")
    check(server.ask("GET", f"/api/runs/{study}/values")[0] == 404, "a study has no results of a single case")
    (folder / "frames.toml").write_text(LONG + "\n[output]\nframe_interval = 0.2\n", encoding="utf-8")
    run = server.ask("POST", "/api/runs", {"path": "frames.toml"})[1]["id"]
    frames = [data for kind, data in server.watch(run, lambda event: event[0] == "frame" and event[1]["time"] > 0.3) if kind == "frame"]
    frame = frames[-1]
    check(frame["count"] > 100 and len(frame["x"]) == len(frame["y"]) == len(frame["displacement"]) <= 4000, "points of a frame")
    check(0 <= min(frame["x"]) and max(frame["x"]) <= 44 and 0 <= min(frame["y"]) and max(frame["y"]) <= 17, "points lie in the box")
    check(max(frame["displacement"]) > 0 and frame["stage"] == "long", "points have moved")
    report = server.ask("GET", f"/api/runs/{run}/report-data")[1]
    check(report["active"] and report["data"]["report"]["sequences"][0]["frames"], "the report of a run in progress has its frames")
    check(report["data"]["results"]["result"]["status"] == "unfinished" and report["data"]["results"]["result"]["input"], "it has the input of the run")
    server.ask("POST", f"/api/runs/{run}/stop")
    check(server.watch(run)[-1][1]["state"] == "stopped", "the run with frames is stopped")


def check_stop_and_restart(server, folder, program):
    (folder / "long.toml").write_text(LONG, encoding="utf-8")
    long = server.ask("POST", "/api/runs", {"path": "long.toml"})[1]["id"]
    waiting = server.ask("POST", "/api/runs", {"path": "slope.toml"})[1]["id"]
    later = server.ask("POST", "/api/runs", {"path": "slope.toml"})[1]["id"]
    events = server.watch(long, lambda event: event[1].get("stage"))
    check(events[-1][1].get("stage") == "long" and 0 <= events[-1][1]["fraction"] <= 1, f"progress: {events[-1]}")
    check(server.ask("POST", f"/api/runs/{later}/stop")[0] == 200, "stop of a waiting run")
    check(server.watch(later)[-1][1]["state"] == "stopped", "a waiting run is stopped")
    # kill -9 of the server: the run goes on, and the next server finds it, the queue and the journal.
    server.end(signal.SIGKILL)
    server = Server(program, folder)
    states = {r["id"]: r["state"] for r in server.ask("GET", "/api/runs")[1]["runs"]}
    check(states[long] == "running" and states[waiting] == "waiting", f"states after a restart: {states}")
    check([e["text"] for e in server.ask("GET", "/api/journal/slope.toml")[1]["entries"]] == ["typed"], "journal after a restart")
    server.watch(long, lambda event: event[1].get("stage"))
    check(server.ask("POST", f"/api/runs/{long}/stop")[0] == 200, "stop")
    check(server.watch(long)[-1][1]["state"] == "stopped", "a stopped run")
    check(server.watch(waiting)[-1][1]["state"] == "done", "the queue goes on")
    check(server.ask("POST", f"/api/runs/{waiting}/resume")[0] == 409, "a finished run cannot be resumed")
    check(server.ask("POST", f"/api/runs/{long}/resume")[0] == 200, "resume")
    server.watch(long, lambda event: event[1].get("stage"))
    check(server.ask("POST", f"/api/runs/{long}/stop")[0] == 200, "stop of the resumed run")
    check(server.watch(long)[-1][1]["state"] == "stopped", "the resumed run is stopped")
    return server


def check_two_servers(server, folder, program):
    other = Server(program, folder)
    run = other.ask("POST", "/api/runs", {"path": "slope.toml"})[1]["id"]
    check(server.watch(run)[-1][1]["state"] == "done", "a run of the other server")
    revision = server.ask("GET", "/api/files/slope.toml")[1]["revision"]
    check(other.ask("PUT", "/api/files/slope.toml", {"text": CASE + "#", "revision": revision})[0] == 200, "other server saves")
    check(server.ask("PUT", "/api/files/slope.toml", {"text": CASE, "revision": revision})[0] == 409, "this one is told")
    check(other.end() == 0, "the other server ends")


def check_hostile(server, count, folder):
    source = random.Random(60)
    before = sorted(p.name for p in folder.parent.iterdir())
    for number in range(count):
        request = make_hostile(source, server.token, server.port)
        try:
            with socket.create_connection(("127.0.0.1", server.port), TIMEOUT) as connection:
                connection.sendall(request)
                connection.shutdown(socket.SHUT_WR)
                while connection.recv(65536):
                    pass
        except OSError as error:
            if isinstance(error, socket.timeout):
                check(False, f"request {number} gave no end: {request[:200]!r}")
        if server.process.poll() is not None:
            check(False, f"request {number} ended the server ({server.process.returncode}): {request[:2000]!r}")
            return
    check(server.ask("GET", "/api/files")[0] == 200, "the server answers after hostile requests")
    check(sorted(p.name for p in folder.parent.iterdir()) == before, "nothing was written outside the folder")


def main():
    program, count = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 1000
    if not has_module(program, "libtalus_http.so"):
        print("SKIP: this build has no cpp-httplib ('make program' adds it): the server of the studio was NOT tested")
        return 77
    for module, what in (("libtalus_gdal.so", "drawings"), ("libtalus_xlsx.so", "workbooks")):
        if not has_module(program, module):
            print(f"SKIP: this build has no {module} ('make program' adds it): imports and exports of {what} were NOT tested")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name).resolve() / "cases"
        (folder / "inner").mkdir(parents=True)
        (folder / "slope.toml").write_text(CASE, encoding="utf-8")
        (folder / "inner/other.toml").write_text(CASE, encoding="utf-8")
        (folder / "notes.txt").write_text("notes")
        (folder / "inner/ground.csv").write_text("x [m],y [m]\n0,15\n12,15\n32,5\n44,5\n")
        (folder / ".hidden.toml").write_text("hidden")
        (folder.parent / "secret.toml").write_text("secret")
        (folder / "link.toml").symlink_to(folder.parent / "secret.toml")
        (folder / "linked").symlink_to(folder.parent)
        os.mkfifo(folder / "pipe.toml")
        server = Server(program, folder)
        try:
            check_admission(server)
            check_engine(server)
            check_files(server, folder)
            check_imports(server, folder)
            check_asides(server, folder)
            check_runs(server, folder, program)
            check_results(server, folder, program)
            check_method_checks(server, folder, program)
            check_study_and_frames(server, folder)
            server = check_stop_and_restart(server, folder, program)
            check_two_servers(server, folder, program)
            check_hostile(server, count, folder)
            for run in server.ask("GET", "/api/runs")[1]["runs"]:
                if run["state"] in ("waiting", "running"):
                    server.ask("POST", f"/api/runs/{run['id']}/stop")
                    server.watch(run["id"])
            check(server.end() == 0, "the server ends at a signal")
        finally:
            if server.process.poll() is None:
                server.process.kill()
    print(f"{len(faults)} faults" if faults else "the server of the studio: no faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
