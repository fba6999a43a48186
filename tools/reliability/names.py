# SPDX-License-Identifier: MIT
"""Hostile names of everything that a case or a list of jobs names: nothing outside the folder of results changes, and nothing that is printed or written steers what reads it."""
import csv
import html.parser
import io
import json
import re
import shutil
import xml.etree.ElementTree

from reliability.trial import Table, run, seed, snapshot, tell_difference

CASE = """title = %(title)s
[project]
name = %(project)s
client = %(client)s
author = %(author)s
notes = %(notes)s
[geometry]
box = [[0, 0], [14, 7]]
[[geometry.polygon]]
name = %(polygon)s
points = [[0, 0], [14, 0], [14, 1.5], [9, 1.5], [5, 5], [0, 5]]
[[geometry.line]]
name = %(line)s
points = [[0, 5], [5, 5]]
[mesh]
size = 1.2
[regions]
%(polygon)s = %(material)s
[[boundary]]
on = "bottom"
fix = "full"
[[boundary]]
on = "left"
fix = "normal"
[[boundary]]
on = "right"
fix = "normal"
[[surcharge]]
name = %(surcharge)s
x = [1, 3]
load = [5, 5]
[[stage]]
name = %(stage)s
duration = 0.3
damping = 0.75
[analysis]
methods = ["mpm", "lem", "fem"]
[fem]
size = 2
resolution = 0.2
meshes = 1
[lem]
methods = ["spencer"]
noncircular = false
referee = false
entry_exit = { entries = 6, exits = 6, depths = 5 }
[[lem.surface]]
name = %(surface)s
centre = [8, 8]
radius = 6.6
[materials.%(material)s]
model = "mohr_coulomb"
grain_density = 2650
porosity = 0.42
young_modulus = "15 MPa"
poisson_ratio = 0.3
cohesion = "5 kPa"
friction_angle = "28 deg"
dilatancy_angle = 0
tensile_strength = 0
[output]
frame_interval = 0.1
cells = true
[[output.monitor]]
name = %(monitor)s
at = [5, 5]
[[output.section]]
name = %(section)s
from = [3, 0]
to = [3, 5]
[[compare]]
name = "lem.spencer"
value = 1.5
tolerance = "5 %%"
source = %(source)s
"""
STUDY = """[study]
base_name = %(base)s
factors = []
[[study.vary]]
key = "mesh.size"
values = [1.2, 1.3]
names = [%(first)s, %(second)s]
"""
KEYS = ("title", "project", "client", "author", "notes", "polygon", "line", "material", "surcharge", "stage", "surface", "monitor", "section", "source", "base",
        "first", "second")
# A picture that nothing names but the hostile names.
MARK = "talus-hostile"
HOSTILE = ("..", ".", "", " ", "../../outside/precious", "../..", "a/b", "a/../../c", "/", "//", "{absolute}", "{absolute}/precious", "~", "~/x", "a\0b", "\0", "a\nb",
           "a\r\nb", "a\tb", "\x1b]0;owned\x07", "\x1b[31mred\x1b[2J", "\x9b31m", "\x7f", "\b\b\b", "con", "NUL", "aux.txt", "com1", "frames", "sections", "trials", "jobs",
           "case", "summary.json", "talus.lock", "talus.files", "study.csv", ".git", ".hidden", "-rf", "--overwrite", "=1+1", "+1+cmd|'/C calc'!A0", "@SUM(A1)",
           "-2+3", "x" * 300, "ü" * 150, "\u202eltr", "\u2066x\u2069", "\u200fx", "\u2028x", "\ufeffx", "\uffff", "a\\b", "..\\..\\c", "C:\\x", "'", '"', "a'b\"c",
           "`touch pwned`", "'; system('touch pwned'); '", "\"; system(\"touch pwned\"); \"", "$(touch pwned)", "%s%n", "{}", "{0}", "<b>&amp;</b>", "]]>", "<!--", "-->",
           f"</script><img src={MARK}>", f'"><img src={MARK}>', f"</text><image href='{MARK}'/>", "a,b;c\td", '"a""b', "#comment", "a = b", "[x]", "😀", "e\u0301")
CONTROL = re.compile("[\x00-\x09\x0b-\x1f\x7f-\x9f\u200e\u200f\u2028-\u202e\u2066-\u2069\ufffe\uffff]")
NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$|[-+]?(nan|inf)$")


def quote(text):
    """The text as a string of TOML."""
    return '"' + "".join(c if " " <= c < "\x7f" and c not in '"\\' else f"\\u{ord(c):04x}" if ord(c) < 65536 else f"\\U{ord(c):08x}" for c in text) + '"'


def is_refused(key, name):
    """Names that `check` refuses in their place, so that nothing behind it would be tried."""
    if key == "section":
        return name[:1] in ("", ".") or any(c in '/\\,"[]' or c < " " or c == "\x7f" for c in name) or len(name.encode()) > 150
    return not name or (key != "notes" and any(c in "\n\r" for c in name)) or (key == "monitor" and any(c in ',"' for c in name))


def draw_names(rng, sandbox, passes):
    """A name for every place of the case: a plain one, or a hostile one; where it `passes`, none that `check` refuses."""
    share = rng.choice((0.1, 0.3, 1))

    def draw(key):
        if rng.random() > share:
            return key
        name = rng.choice(HOSTILE).replace("{absolute}", str(sandbox / "outside")) + rng.choice(("", "", "", key, rng.choice(HOSTILE[:40])))
        return key if passes and is_refused(key, name) else name
    return {key: draw(key) for key in KEYS}


class Images(html.parser.HTMLParser):
    """Elements of a page that a name brought into it."""

    def __init__(self):
        super().__init__()
        self.found = ""

    def handle_starttag(self, tag, attrs):
        if any(value and value.strip("'") == MARK for _, value in attrs):
            self.found = f"a name became the element <{tag}>"


def find_fault_in_file(path):
    """Says how a file would steer the program that reads it; empty where it does not."""
    if path.suffix not in (".svg", ".xdmf", ".csv", ".gp", ".html", ".md", ".slurm"):
        return ""
    text = path.read_bytes().decode()
    if path.suffix == ".html":
        page = Images()
        page.feed(text)
        return page.found
    if path.suffix in (".svg", ".xdmf"):
        try:
            xml.etree.ElementTree.fromstring(text)
        except xml.etree.ElementTree.ParseError as error:
            return f"is no XML: {error}"
    if found := CONTROL.search(text.replace("\t", " ") if path.suffix == ".svg" else text):  # gnuplot writes tabs
        return f"holds the raw character U+{ord(found[0]):04X}"
    if path.suffix == ".csv":
        for cell in (cell for row in csv.reader(io.StringIO(text)) for cell in row):
            if cell[:1] in tuple("=+-@") and not NUMBER.match(cell):
                return f"has the cell {cell[:40]!r}, a formula of spreadsheets"
    return ""


def find_fault_in_results(folder, work):
    """The first fault of a file of results; scripts of gnuplot are drawn in a copy of their folder."""
    for path in sorted(folder.rglob("*")):
        if CONTROL.search(path.name):
            return f"the name {path.name!r} holds a control character"
        if not path.is_file() or path.is_symlink():
            continue
        try:
            fault = find_fault_in_file(path)
        except UnicodeDecodeError:
            fault = "is no UTF-8"
        if fault:
            return f"{path.relative_to(folder)} {fault}"
        if path.suffix == ".gp":
            drawn = work / "drawn"
            shutil.rmtree(drawn, ignore_errors=True)
            shutil.copytree(path.parent, drawn)
            run("gnuplot", [path.name], 30, cwd=drawn)
            if (drawn / "pwned").exists():
                return f"{path.relative_to(folder)} starts a command when gnuplot reads it"
    return ""


def rename_jobs(path, rng, sandbox):
    """Puts hostile names into one to three places of a list of jobs."""
    tree = json.loads(path.read_text())
    places = []

    def walk(node):
        for key, value in node.items() if isinstance(node, dict) else enumerate(node):
            if isinstance(value, str) and key not in ("version", "commit", "level"):
                places.append((node, key))
            elif isinstance(value, (dict, list)):
                walk(value)
    walk(tree)
    folders = [place for place in places if place[1] in ("folder", "name")]
    for _ in range(rng.choice((1, 1, 2, 3))):
        node, key = rng.choice(folders if folders and rng.random() < 0.7 else places)
        node[key] = rng.choice(HOSTILE).replace("{absolute}", str(sandbox / "outside"))
    path.write_text(json.dumps(tree))


def list_commands(kind, case, out):
    """The commands of one trial, one after the other."""
    if kind == "run":
        return [["check", case], ["run", case, "-o", out, "--threads", "1"], ["plot", out], ["report", out]]
    if kind == "study":
        return [["study", case, "-o", out, "--threads", "1"], ["report", out]]
    return [["study", case, "--prepare", out], "rename", ["study", out, "--job", "0", "--threads", "1"], ["study", out, "--job", "1", "--threads", "1"],
            ["study", out, "--collect", "--threads", "1"]]


def try_names(program, numbers, work):
    table = Table("names", "hostile names in case files and lists of jobs: nothing outside the folder changes, nothing written steers a terminal, a browser, a "
                  "spreadsheet or gnuplot")
    for number in numbers:
        rng = seed("names", number)
        sandbox = work / "sandbox"
        shutil.rmtree(sandbox, ignore_errors=True)
        for folder in ("outside", "here/results", "home"):
            (sandbox / folder).mkdir(parents=True)
        for path in ("outside/precious", "here/precious", "here/results/precious", "home/x"):
            (sandbox / path).write_text("mine")
        kind = rng.choice(("run", "run", "study", "jobs"))
        names = draw_names(rng, sandbox, kind == "jobs" or rng.random() < 0.8)
        fill = {key: quote(name) for key, name in names.items()}
        case, out = sandbox / "here" / "case.toml", sandbox / "here" / "results" / "out"
        case.write_text(CASE % fill + (STUDY % fill if kind != "run" else ""))
        before = snapshot(sandbox)
        commands = list_commands(kind, "case.toml", "results/out")
        for command in commands:
            if command == "rename":
                if (out / "jobs.json").exists():
                    rename_jobs(out / "jobs.json", rng, sandbox)
                continue
            if command[0] in ("plot", "report") and not out.exists():
                continue
            verdict = run(program, command, cwd=case.parent, env={"HOME": str(sandbox / "home"), "PATH": "/usr/bin:/bin"})
            fault = judge(verdict, before, sandbox, out)
            if command is commands[-1] and out.exists():
                fault = fault or find_fault_in_results(out, work)
            table.add(f"{number} ({' '.join(command[:3])})", verdict, fault)
    return table


def judge(verdict, before, sandbox, out):
    """The change outside the folder of results, or the control character that was printed; empty where there is none."""
    after = {path: what for path, what in snapshot(sandbox).items() if path != str(out) and not path.startswith(f"{out}/")}
    after = {path: what for path, what in after.items() if not path.startswith(str(sandbox / "home" / ".fltk"))}  # folders of a library of Gmsh
    if changed := tell_difference(before, after):
        return changed
    for stream, text in (("standard output", verdict.printed), ("standard error", verdict.said)):
        if found := CONTROL.search(text):
            return f"{stream} has the raw character U+{ord(found[0]):04X}: {text[max(0, found.start() - 60):found.end() + 20]!r}"
    return ""
