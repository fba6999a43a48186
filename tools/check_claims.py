#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the names that documents have in backticks against the tree: files and folders, commands and their options, targets of make,
tests, keys of a case, names of the sources, messages of the program. Exits with 1 and one line per claim that is not true.

The number of the version is the same in all files, and every folder of src/ has its row in docs/architecture.md.

Usage: check_claims.py | check_claims.py --self-test

It reads text and runs nothing: a name exists when it is in the code (comments do not count), `a.b` when the two are together
there. CHANGELOG.md describes the past and is not read, nor are decisions with the status `replaced by`.
"""
import re
import sys
import tempfile
from fnmatch import fnmatch
from functools import cached_property
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests/docs"))
from markdown import find_pages  # noqa: E402

# Names that documents may use although the tree has none of them: why, and which.
EXCEPTIONS = {
    "kinds of names, not names": "CamelCase snake_case Manager Utils Helper [x] [[x]]",
    "folders that 0023 did away with": "model/ methods/",
    "alternatives that decisions weigh": "User_Mod multifit_nlinear solve_least_squares_lm LevenbergMarquardt UMFPACK_IRSTEP "
                                         "std::experimental::simd std::simd scikit-build-core thread_safe",
    "of the system, of Fortran, HDF5 and ParaView": "dlclose OMP_NUM_THREADS lib/python3.11/dist-packages COMMON SAVE STOP "
                                                    "SINV SPRINC ROTSIG XIT Tensor6 XSync tobytes",
}
NAMES_OF_OTHERS = {name for names in EXCEPTIONS.values() for name in names.split()}
# Programs of others: what follows them is theirs.
FOREIGN = {"apt-get", "cmake", "ctest", "git", "gmsh", "gnuplot", "kill", "paraview", "pip", "pvpython", "sudo", "xvfb-run"}
CODE = set(".cpp .hpp .in .cu .py .ts .tsx .css .mjs .js .sh .cmake .toml .f .json .txt".split())
WITHOUT_ENDING = {"Makefile", "run", "apt-packages"}
# At the root: files that builds and runs leave there. This file itself is not evidence for a name.
NOT_OURS = {".git", "build", "results"}
NO_CODE = {"package-lock.json", Path(__file__).name}
ENDING = re.compile(r"[\w*]\.(?:[ch]pp|py|tsx?|m?js|css|sh|toml|md|json|csv|svg|png|gp|h5|html|vtkhdf|xdmf|vtu|msh|txt|f)$")
HOLE = re.compile(r"\*|…|\[NAME\]|[A-Z]{3,}(?=_|\b)|[\d.]*\d")  # NAME, CASE, FOLDER, …, numbers: the reader's own
TEST = re.compile(r"^(?:TYPED_)?TEST(?:_F|_P)?\((\w+),\s*(\w+)\)", re.M)
BLOCK = re.compile(r"^( *)```(\w*)\n(.*?)^ *```[ ]*$", re.S | re.M)


def strip_comments(name, text):
    hash_begins = name.endswith((".py", ".sh", ".toml", ".cmake", ".txt"))
    return re.sub(r"^\s*#.*$" if hash_begins else r"(?<![:\"'])//.*$", "", text, flags=re.M)


class Tree:
    """The source tree: names of files, and the code in them."""

    def __init__(self, root):
        self.files, self.code = [], {}
        for path in sorted(root.rglob("*")):
            parts = path.relative_to(root).parts
            if parts[0] in NOT_OURS or {"node_modules", "__pycache__"} & set(parts):
                continue
            name = "/".join(parts)
            self.files.append(f"/{name}/" if path.is_dir() else f"/{name}")
            if path.is_file() and (path.suffix in CODE or path.name in WITHOUT_ENDING) and path.name not in NO_CODE:
                self.code[name] = strip_comments(path.name, path.read_text(encoding="utf-8"))
        self.text = "\n".join(self.code.values())
        self.words = set(re.findall(r"\w+", self.text))
        self.pairs = set(re.findall(r"\b(\w+)(?:\[[^\]\n]*\]|\(\))*(?:\.|->|::)(?=(\w+))", self.text))

    def join(self, *starts):
        return "\n".join(text for name, text in self.code.items() if name.startswith(starts))

    @cached_property
    def messages(self):
        """Messages of the program, with adjacent literals joined, and holes for values."""
        joined = re.sub(r'"\s*"', "", self.join("src/", "python/", "web/src/"))
        return re.sub(r"\{[^{}\n]*\}", "…", joined)

    @cached_property
    def written(self):
        """The names in quotes of what writes files: the program, the package, the scripts of the manual."""
        return "\n".join(re.findall(r'"[^"\n]*"', self.join("src/", "python/", "docs/manual/", "docs/site/")))

    @cached_property
    def keys(self):
        return set(re.findall(r'"([a-z]\w*)"', self.join("src/input/") + self.join("src/material/")))

    @cached_property
    def named(self):
        """Blocks of a case whose entries the user names."""
        return set(re.findall(r'v\.(?:tables|named|entries)\(\s*"(\w+)"', self.join("src/input/")))

    @cached_property
    def tests(self):
        python = {f"python.{name[18:-3]}" for name in self.code if name.startswith("python/tests/test_")}
        return python | set(re.findall(r"add_test\(NAME (\S+)", self.text)) | {
            f"{name.split('/')[1]}.{found[1]}.{found[2]}"
            for name, text in self.code.items() if name.startswith("tests/") for found in TEST.finditer(text)}

    @cached_property
    def kinds_of_tests(self):
        return {test.split(".")[0] for test in self.tests}

    @cached_property
    def commands(self):
        """{command of talus: its options}"""
        shared = set(re.findall(r"--[a-z][\w-]+", self.code.get("src/app/case_options.cpp", "")))
        return {command: {"--help", *re.findall(r"--[a-z][\w-]+", text), *(shared if "case_options.hpp" in text else [])}
                for name, text in self.code.items() if name.startswith("src/app/")
                for command in re.findall(r'Command(?: command)?\(\s*app,\s*"(\w+)"', text)}

    def has_file(self, claim, page):
        """Returns whether a path ends with the claim (a program with its source), or lies beside the page."""
        claim = re.sub(r"…|NAME", "*", claim.strip("/"))
        if "*" in claim:
            return any(fnmatch(file, f"*/{claim}{end}") for file in self.files for end in ("", "/"))
        return (page.parent / claim).exists() or any(
            file.endswith((f"/{claim}", f"/{claim}/", f"/{claim}.cpp")) for file in self.files)


def find_spans(text):
    """(line, span) of every `span` outside blocks of code."""
    plain = BLOCK.sub(lambda m: "\n" * m[0].count("\n"), text)
    for found in re.finditer(r"(`+)(?!`)(.+?)(?<!`)\1(?!`)", plain, flags=re.S):
        yield plain.count("\n", 0, found.start()) + 1, " ".join(found[2].split())


class Page:
    """One document against the tree. Each check yields messages."""

    def __init__(self, tree, path, text):
        self.tree, self.path, self.text = tree, path, text
        # Files that the reader makes are in a block of the page, or in a command.
        commands = [span for _, span in find_spans(text) if span.startswith("talus ")]
        self.own = "\n".join([block for _, _, block in BLOCK.findall(text)] + commands)

    def check_file(self, claim):
        claim = claim.split("#")[0]
        if program := re.fullmatch(r"build/[^/]+/(\w+)/([a-z]\w+)", claim):
            made = program[2] == "talus" or self.tree.has_file("tests/" + program[2].removeprefix("test_"), self.path) or (
                self.tree.has_file(f"bench/{program[2]}.cpp", self.path))
            if program[1] != "bin" or not made:
                yield f"the build makes no '{claim}'"
        elif self.tree.has_file(claim, self.path):
            return
        elif re.search(r"\.(?:[ch]pp|py|tsx?|m?js|sh)$", claim):
            yield f"there is no file '{claim}'"
        elif (first := claim.split("/")[0]) not in NOT_OURS and not re.search(rf"(?<![\w.]){re.escape(first)}(?!\w)", self.own):
            stem = claim.rstrip("/").rpartition(".")[0] if ENDING.search(claim) else claim
            parts = [part for piece in HOLE.split(stem) for part in piece.split("/") if part]
            missing = [part for part in parts if part.strip("_") not in self.tree.keys
                       and not re.search(rf"(?<![^\W_]){re.escape(part)}(?![^\W_])", self.tree.written)]
            if missing:
                yield f"there is no file or folder '{claim}', and nothing writes '{missing[0]}'"

    def check_command(self, words):
        """A command of talus, a target of make, a script of npm or of ours."""
        program, rest = words[0].split("/")[-1], words[1:]
        options = sorted({word.split("=")[0] for word in rest if re.match(r"--[a-z]", word)})
        if program == "talus":
            known = self.tree.commands.get(rest[0])
            if known is None and re.fullmatch(r"[a-z]+", rest[0]):
                yield f"talus has no command '{rest[0]}'"
            yield from (f"talus {rest[0]} has no option '{option}'" for option in options if known and option not in known)
            for word in rest[1:]:
                if word.startswith("examples/"):
                    yield from self.check_file(word)
        elif program == "make":
            for word in rest:
                name, assigned, value = word.partition("=")
                line = rf"^{re.escape(name)}\s*{'[?:]?=' if assigned else ':'}"
                if not re.search(line, self.tree.code["Makefile"], flags=re.M):
                    yield f"make has no {'variable' if assigned else 'target'} '{name}'"
                elif name == "PRESET" and f'"{value}"' not in self.tree.code["CMakePresets.json"]:
                    yield f"there is no preset '{value}'"
        elif program == "npm":
            scripts = "".join(text for name, text in self.tree.code.items() if name.endswith("package.json"))
            if rest[0] == "run" and f'"{rest[1]}":' not in scripts:
                yield f"npm has no script '{rest[1]}'"
        else:
            yield from self.check_file(words[0])
            text = "".join(code for name, code in self.tree.code.items() if name.endswith(words[0]))
            yield from (f"{words[0]} has no option '{option}'" for option in options if text and option not in text)

    def check_key(self, key):
        """A key of a case, its blocks before it; names that the user chose are left out."""
        parts = [part for part in key.split(".") if part]
        kept = [part for before, part in zip(["", *parts], parts) if before not in self.tree.named]
        unknown = [part for part in kept if re.match(r"[a-z]", part) and part not in self.tree.keys | NAMES_OF_OTHERS]
        if unknown and not re.search(rf"\b{re.escape(parts[-1])}=", self.tree.join("python/")):
            yield f"no key of a case is called '{unknown[0]}'"
        elif len(parts) == len(kept):
            yield from self.check_neighbours(key)

    def check_neighbours(self, span):
        """a.b and A::b: the names are adjacent in the code, two keys of one file, or a class and its member."""
        for one, joint, other in re.findall(r"(?=\b([A-Za-z_]\w*)(?:\[[^\[\]]*\]|\(\))?(\.|::)([A-Za-z_]\w+))", span):
            if (one, other) in self.tree.pairs or one in self.tree.named or one == "talus" or HOLE.fullmatch(other):
                continue
            both = [f'"{one}"', f'"{other}"'] if joint == "." else [f" {one}", f" {other}"]
            if not any(all(word in text for word in both) for text in self.tree.code.values()):
                yield f"nothing has '{one}{joint}{other}'"

    def check_name(self, span):
        """Names of the sources: each word, and neighbours. A word may be made of two: `shear_strain_` and `associated`."""
        words, bare = self.tree.words, re.sub(r'"[^"]*"', "", span)
        for word in re.findall(r"[A-Za-z_]\w\w+", HOLE.sub("", bare) if "NAME" in bare else bare):
            cuts = [(word[:at], word[at:]) for at in range(len(word)) if word[at - 1] == "_"]
            made = any(start in words and end in words or start[:-1] in words and "_" + end in words for start, end in cuts)
            if not (made or word in words or word in NAMES_OF_OTHERS or word.strip("_") != word and word.strip("_") in words):
                yield f"no source has the name '{word}'"
                return
        for call in re.findall(r"(\w\w+)\(\)", bare):
            if call not in NAMES_OF_OTHERS and not re.search(rf"\b{call}\b\s*(?:<[^<>]*>)?\(", self.tree.text):
                yield f"no source has a function '{call}()'"
        if not re.search(r"\w\(", bare):
            yield from self.check_neighbours(bare)

    def check_message(self, span):
        for part in re.split(r"…|'|:|;", span):
            if len(part.strip()) > 3 and part.strip() not in self.tree.messages:
                yield f"the program does not say '{part.strip()}'"

    def check_span(self, span):
        words = span.split()
        if words[0] in FOREIGN or span in NAMES_OF_OTHERS or not re.search(r"[A-Za-z]{2}", span):
            return
        words = words[words[0] in ("node", "python3"):]
        if len(words) > 1 and re.fullmatch(r"(?:\S*/)?(?:talus|make|npm)|build/\S+|\S+/\S+\.(?:py|sh|mjs)", words[0]):
            yield from self.check_command(words)
        elif option := re.match(r"--?[A-Za-z][\w-]+", span):
            if option[0].startswith("--") and option[0] not in self.tree.text:
                yield f"no source has the option '{option[0]}'"
            if setting := re.match(r"--set ([a-z_.]+)=", span):
                yield from self.check_key(setting[1])
        elif re.fullmatch(r"[A-Z]+=\S+", span) and words[0].split("=")[0] in self.tree.code["Makefile"]:
            yield from self.check_command(["make", span])
        elif re.match(r"[a-z]+\.(?:[A-Z]\w*[a-z]|\*)", span) and span.split(".")[0] in self.tree.kinds_of_tests:
            if not any(fnmatch(test, span) or test.startswith(span + ".") for test in self.tree.tests):
                yield f"there is no test '{span}'"
        elif table := re.match(r"\[+([a-z_.]+)(?:\.[A-Z…]+)?\]+(?: ([a-z_.]+)(?: = .*)?)?$", span):
            yield from self.check_key(table[1])
            yield from self.check_key(table[2] or "")
        elif assigned := re.match(r"([a-z_.]+) ?= ?\S", span):
            yield from self.check_key(assigned[1])
        elif self.tree.has_file(span, self.path):
            return
        elif len(words) == 1 and (ENDING.search(span) or re.fullmatch(r"[\w.*…-]*/[\w.*/…#-]*", span)):
            yield from self.check_file(span)
        elif re.search(r"[a-z]+ [a-z]+", span) and not re.search(r'[=()\[\]{}<>*"]', span):
            yield from self.check_message(span)
        else:
            yield from self.check_name(span)

    def check_block(self, language, block):
        """(line in the block, fault): keys of toml, commands of a shell."""
        table = ""
        for number, line in enumerate(block.splitlines()):
            words = line.split(" #")[0].split()
            if language == "toml":
                # The keys of [regions] are names of the user's.
                table = line.strip("[] ") if re.match(r"\[\w+\]", line) else "" if line.startswith("[") else table
                key = re.match(r"\s*(?:\[+([a-z_.]+)(?:\.\w+)?\]|([a-z_.]+)\s*=)", line)
                if key and (key[1] or table not in self.tree.named):
                    yield from ((number, fault) for fault in self.check_key(key[1] or key[2]))
            elif len(words) > 1 and re.fullmatch(r"(?:\S*/)?talus|make|npm|tools/\S+", words[0]):
                yield from ((number, fault) for fault in self.check_command(words))


def check_versions(root):
    """The files that repeat the number of the version (RELEASING.md)."""
    number = re.search(r"project\(talus VERSION ([\d.]+)", (root / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
    for name in ("CITATION.cff", *(f"{folder}/package{lock}.json" for folder in ("web", "docs/site") for lock in ("", "-lock"))):
        found = re.search(r'^(?:version:|\s*"version":) "?([\d.]+)', (root / name).read_text(encoding="utf-8"), flags=re.M)[1]
        if found != number:
            yield f"{name}: the version is {found}, and in CMakeLists.txt {number}"


def check_folders(root):
    rows = re.findall(r"^\| `([\w/]+)/` \|", (root / "docs/architecture.md").read_text(encoding="utf-8"), flags=re.M)
    folders = {path.parent.relative_to(root / "src").as_posix() for path in (root / "src").rglob("*.[ch]pp")}
    yield from (f"docs/architecture.md: src/{folder}/ has no row" for folder in sorted(folders - set(rows)))


def find_faults(root):
    yield from check_versions(root)
    yield from check_folders(root)
    tree = Tree(root)
    for path in find_pages(root):
        name, text = path.relative_to(root).as_posix(), path.read_text(encoding="utf-8")
        if name == "CHANGELOG.md" or re.search(r"^\*\*Status:\*\*.*\breplaced by", text, flags=re.M):
            continue
        page = Page(tree, path, text)
        for line, span in find_spans(text):
            yield from (f"{name}:{line}: `{span}`: {fault}" for fault in page.check_span(span))
        for found in BLOCK.finditer(text):
            line = text.count("\n", 0, found.start()) + 2
            yield from (f"{name}:{line + inner}: {fault}" for inner, fault in page.check_block(found[2], found[3]))


def run_self_test():
    """Every kind of claim must be able to fail: a small tree, a page that is true of it, and claims that are not."""
    tree = {
        "Makefile": "docs: all\nPRESET ?= release\n", "CMakePresets.json": '{"name": "release"}\n',
        "web/package.json": '{"scripts": {"lint": "oxlint"},\n"version": "1.2.3"}\n', "web/package-lock.json": '"version": "1.2.3"\n',
        "docs/site/package.json": '"version": "1.2.3"\n', "docs/site/package-lock.json": '"version": "1.2.3"\n',
        "CITATION.cff": "cff-version: 1.2.0\nversion: 1.2.2\n", "CMakeLists.txt": "project(talus VERSION 1.2.3)\n",
        "src/app/case_options.cpp": 'command.take("--set", s);\n',
        "src/app/run.cpp": 'const Command command(app, "run", "x");\ncommand.take("--threads", n);\nwrite("summary.json");\n',
        "src/input/case/case.hpp": 'v.tables(\n"stage", s);\nv.key("mesh", m);\nv.key("size", m.size, "the soil of "\n"{} is weak");\n',
        "src/fem/solve.hpp": "struct Solver { void find_root(); };  // once find_zero\n",
        "tests/unit/solve.cpp": "TEST(Solve, FindsTheRoot) {}\n", "tools/draw.py": 'add("--wide")\n',
    }
    true = ["fem/solve.hpp", "solve.*", "src/fem/", "summary.json", "talus run case.toml --threads 2", "--threads", "make docs",
            "make docs PRESET=release", "npm run lint", "tools/draw.py --wide", "unit.Solve", "unit.Solve.*", "[[stage]]", "mesh.size",
            "--set mesh.size=2", "size = 0.5", "find_root()", "Solver::find_root", "the soil of … is weak", "build/release/bin/test_unit",
            "sudo make it so"]
    false = ["fem/solver.hpp", "solver.*", "src/lem/", "totals.json", "talus walk case.toml", "talus run case.toml --fast", "--fast",
             "make tea", "make docs PRESET=quick", "npm run away", "tools/draw.py --narrow", "tools/paint.py", "unit.Solver", "[[stages]]",
             "mesh.width", "--set mesh.width=2", "width = 0.5", "find_zero()", "find_zero", "Solver::find_zero", "the soil of … is strong",
             "build/release/tests/test_unit"]
    blocks = "```toml\n[[stage]]\nsize = 1\nwidth = 1\n```\n\n```\ntalus run case.toml\ntalus walk case.toml\n```\n"
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        pages = {"README.md": "".join(f"`{claim}`\n" for claim in true), "docs/wrong.md": "".join(f"`{claim}`\n" for claim in false),
                 "docs/architecture.md": "| `app/` | x |\n| `input/case/` | x |\n", "docs/blocks.md": blocks, "docs/old.md": "**Status:** replaced by 2\n\n`find_zero`\n", "CHANGELOG.md": "`find_zero`\n"}
        for name, text in {**tree, **pages}.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text, encoding="utf-8")
        found = [fault.split(": ")[0] for fault in find_faults(root)]
    expected = [f"docs/wrong.md:{line}" for line in range(1, len(false) + 1)] + [
        "docs/blocks.md:4", "docs/blocks.md:9", "CITATION.cff", "docs/architecture.md"]
    return [f"self-test: the fault in {place} was not found" for place in expected if place not in found] + [
        f"self-test: {place} is no fault" for place in found if place not in expected]


def main():
    faults = run_self_test() if sys.argv[1:] == ["--self-test"] else list(find_faults(ROOT))
    print("\n".join(faults) if faults else "check_claims: what the documents name is there.")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
