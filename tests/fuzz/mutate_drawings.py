#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Mutants of drawings and of a GeoStudio file never crash `talus import`: each gives a case file or one sentence.

Usage: mutate_drawings.py PROGRAM [COUNT] [SEED]      100 mutants by default
Exits with 77 where the program has no GDAL.
"""
import io
import pathlib
import random
import subprocess
import sys
import tempfile
import zipfile

SEEDS = sorted((pathlib.Path(__file__).parent.parent / "data/drawings").glob("*.dxf"))
MODEL = pathlib.Path(__file__).parent.parent / "data/drawings/geostudio_model.xml"
WORDS = [b"0", b"-1", b"1e308", b"nan", b"99999999999", b"SECTION", b"ENDSEC", b"EOF", b"POLYLINE", b"INSERT", b"SPLINE", b"HATCH", b"BLOCK", b"", b"8", b"70"]


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


def make_mutant(folder, draw):
    if draw.random() < 0.2:
        path = folder / "mutant.gsz"
        path.write_bytes(make_archive(MODEL.read_bytes(), draw))
    else:
        path = folder / "mutant.dxf"
        path.write_bytes(mutate(draw.choice(SEEDS).read_bytes(), draw))
    return path


def main():
    program, count, seed = sys.argv[1], 100, 1
    if len(sys.argv) > 2:
        count = int(sys.argv[2])
    if len(sys.argv) > 3:
        seed = int(sys.argv[3])
    draw = random.Random(seed)
    kinds = {}
    with tempfile.TemporaryDirectory() as scratch:
        case = pathlib.Path(scratch) / "case.toml"
        for i in range(count):
            drawing = make_mutant(pathlib.Path(scratch), draw)
            result = subprocess.run([program, "import", drawing, "-o", case, "--units", "m", "--overwrite"], capture_output=True, timeout=120)
            error = result.stderr.decode(errors="replace").strip()
            if "it has no GDAL" in error:
                print("SKIP: this build has no GDAL")
                return 77
            if result.returncode == 0 or (result.returncode == 2 and error.startswith("talus: error: ") and "\n" not in error):
                kinds[result.returncode] = kinds.get(result.returncode, 0) + 1
                continue
            kept = pathlib.Path.cwd() / f"mutant_{seed}_{i}{drawing.suffix}"
            kept.write_bytes(drawing.read_bytes())
            print(f"mutant {i}: code {result.returncode}, kept as {kept.name}: {error}")
            return 1
    print(f"{count} mutants of {len(SEEDS)} drawings: {kinds.get(0, 0)} read, {kinds.get(2, 0)} refused")
    return 0


if __name__ == "__main__":
    sys.exit(main())
