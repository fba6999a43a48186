#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Mutants of drawings, tables and a GeoStudio file never crash `talus import`: each gives a case file or one sentence.

Usage: mutate_drawings.py PROGRAM [COUNT] [SEED]      100 mutants by default, two at a time
PROGRAM is talus, or import_server (tests/fuzz/import_server.cpp), which loads its libraries once for all mutants.
Exits with 77 where the program has no GDAL.
"""
import concurrent.futures
import io
import pathlib
import random
import subprocess
import sys
import tempfile
import threading
import zipfile

DATA = pathlib.Path(__file__).parent.parent / "data"
DRAWINGS = sorted([*(DATA / "drawings").glob("*.dxf"), *(DATA / "drawings").glob("*.geojson")])
TABLES = sorted([*(DATA / "tables").glob("*.csv"), *(DATA / "tables").glob("*.ags")])
MODEL = DATA / "drawings/geostudio_model.xml"
AT_ONCE = 2
MOST_MEMORY = 3000  # MB; a drawing may take 2000 beyond the program
WORDS = [b"0", b"-1", b"1e308", b"nan", b"99999999999", b"SECTION", b"ENDSEC", b"EOF", b"POLYLINE", b"INSERT", b"SPLINE", b"HATCH", b"BLOCK", b"", b"8", b"70"]
CELLS = [b"", b"0", b"-1", b"1e308", b"-1e-320", b"nan", b"1,5", b"99999999999999999999", b"\"", b"\"a", b"x", b"[ft]", b"(m)", b";", b"\t", b"#", b"\xff\xfe", b"\xef\xbb\xbf", b"hole", b"soil", b"depth", b"\"<CONT>\"", b"\"**GEOL\"", b"\"GROUP\"", b"Unit: ft"]


def mutate(data, draw):
    """Lines swapped, repeated, removed or replaced, or bytes changed."""
    lines = data.split(b"\n")
    for _ in range(draw.choice((1, 1, 2, 5, 20))):
        lines = lines or [b""]
        i = draw.randrange(len(lines))
        kind = draw.randrange(6)
        if kind == 0:
            lines[i] = draw.choice(WORDS)
        elif kind == 1:
            lines[i:i] = lines[i:i + draw.randrange(1, 40)] * draw.choice((1, 2, 200))
        elif kind == 2:
            del lines[i:i + draw.randrange(1, 40)]
        elif kind == 3:
            lines = lines[:max(i, 1)]
        elif kind == 4:
            j = draw.randrange(len(lines))
            lines[i], lines[j] = lines[j], lines[i]
        else:
            line = bytearray(lines[i] or b"0")
            line[draw.randrange(len(line))] = draw.randrange(256)
            lines[i] = bytes(line)
    return b"\n".join(lines)


def make_archive(data, draw):
    """A GeoStudio file: a mutant in an archive, or an archive with changed bytes."""
    buffer = io.BytesIO()
    changes_model = draw.random() < 0.8
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("model.xml", mutate(data, draw) if changes_model else data)
    content = bytearray(buffer.getvalue())
    if not changes_model:
        for _ in range(draw.choice((1, 3, 30))):
            content[draw.randrange(len(content))] = draw.randrange(256)
    return bytes(content)


def mutate_table(data, draw):
    """Cells replaced, moved, removed or repeated, columns swapped; then perhaps lines as in drawings."""
    own = b";" if b";" in data.split(b"\n")[0] else b","
    separator = draw.choice((b",", b";", b"\t", b" ")) if draw.random() < 0.2 else own
    rows = [line.split(own) for line in data.split(b"\n")]
    for _ in range(draw.choice((1, 1, 2, 5, 20))):
        row = rows[draw.choice((0, draw.randrange(len(rows))))]
        i = draw.randrange(len(row))
        kind = draw.randrange(4)
        if kind == 0:
            row[i] = draw.choice(CELLS)
        elif kind == 1:
            row[i:i] = row[i:i + 1] * draw.choice((1, 3, 300))
        elif kind == 2 and len(row) > 1:
            del row[i]
        else:
            j = draw.randrange(len(row))
            for of in (rows if draw.random() < 0.5 else [row]):
                if max(i, j) < len(of):
                    of[i], of[j] = of[j], of[i]
    data = b"\n".join(separator.join(row) for row in rows)
    return mutate(data, draw) if draw.random() < 0.5 else data


def make_mutant(folder, number, draw):
    kind = draw.random()
    path = folder / f"mutant_{number}"
    if kind < 0.15:
        path = path.with_suffix(".gsz")
        path.write_bytes(make_archive(MODEL.read_bytes(), draw))
    elif kind < 0.5 and TABLES:
        seed = draw.choice(TABLES)
        path = path.with_suffix(seed.suffix)
        path.write_bytes(mutate_table(seed.read_bytes(), draw))
    else:
        seed = draw.choice(DRAWINGS)
        path = path.with_suffix(seed.suffix)
        path.write_bytes(mutate(seed.read_bytes(), draw))
    return path


class Program:
    """`talus import`, started for each file."""

    def __init__(self, program, folder):
        self.program, self.case = program, folder / f"case_{threading.get_ident()}.toml"

    def run(self, file):
        result = subprocess.run([self.program, "import", file, "-o", self.case, "--units", "m", "--overwrite"], capture_output=True, timeout=300)
        error = result.stderr.decode(errors="replace").strip()
        return result.returncode, 0, 0, error.removeprefix("talus: error: ") if error.startswith("talus: error: ") else f"no sentence: \n{error}"


class Server:
    """import_server, which forks for each file."""

    def __init__(self, program, folder):
        self.process = subprocess.Popen([program, folder / f"case_{threading.get_ident()}.toml"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def run(self, file):
        self.process.stdin.write(f"{file}\n".encode())
        self.process.stdin.flush()
        line = self.process.stdout.readline().decode(errors="replace").rstrip("\n")
        if line == "no GDAL":
            return 2, 0, 0, "it has no GDAL; 'make program CMAKE_ARGS=-DTALUS_GDAL=ON' adds it"
        code, time, memory, message = line.split("\t", 3)
        return int(code), int(time), int(memory), message


def main():
    program, count, seed = pathlib.Path(sys.argv[1]).resolve(), 100, 1
    if len(sys.argv) > 2:
        count = int(sys.argv[2])
    if len(sys.argv) > 3:
        seed = int(sys.argv[3])
    runner = Server if program.name == "import_server" else Program
    here = threading.local()
    kinds, longest, largest, faults = {}, 0, 0, 0
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)

        def try_mutant(i):
            # Each mutant has its own random numbers, so that one can be made again.
            file = make_mutant(folder, i, random.Random(f"{seed} {i}"))
            if not hasattr(here, "runner"):
                here.runner = runner(program, folder)
            return i, file, here.runner.run(file)

        with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
            for i, file, (code, time, memory, message) in pool.map(try_mutant, range(count)):
                if "it has no GDAL" in message:
                    print(f"SKIP: no mutant was imported: {message}")
                    return 77
                longest, largest = max(longest, time), max(largest, memory)
                if code in (0, 2) and (code == 0 or "\n" not in message) and memory < MOST_MEMORY:
                    kinds[file.suffix, code] = kinds.get((file.suffix, code), 0) + 1
                else:
                    faults += 1
                    kept = pathlib.Path.cwd() / f"mutant_{seed}_{i}{file.suffix}"
                    kept.write_bytes(file.read_bytes())
                    print(f"mutant {i}: code {code}, {time} ms, {memory} MB, kept as {kept.name}: {message}", flush=True)
                file.unlink()
    parts = ", ".join(f"{suffix[1:]} {kinds.get((suffix, 0), 0)} read and {kinds.get((suffix, 2), 0)} refused" for suffix in sorted({k[0] for k in kinds}))
    print(f"{count} mutants, {faults} faults: {parts}" + (f"; longest {longest / 1000:.2f} s of processor time, largest {largest} MB" if runner is Server else ""))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
