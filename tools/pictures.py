# SPDX-License-Identifier: MIT
"""Pictures that the documentation keeps: small ones."""
import re

from PIL import Image

PLACES = re.compile(r'\b(?:d|x|y)="[^"]*"|translate\([^)]*\)')
LONG = re.compile(r"-?\d+\.\d{3,}")


def shorten_svg(text):
    """The text of an SVG with its places in hundredths of a point; scales and widths stay."""
    return PLACES.sub(lambda place: LONG.sub(lambda number: f"{float(number[0]):.2f}".rstrip("0").rstrip("."), place[0]), text)


def save_svg(figure, path):
    """Draws a matplotlib figure as an SVG, a tenth smaller than matplotlib's own."""
    figure.savefig(path, metadata={"Date": None})
    path.write_text(shorten_svg(path.read_text()))


def save_png(figure, path, dpi):
    """Draws a matplotlib figure as a PNG of 64 colours, a quarter of the size that matplotlib's own has."""
    figure.savefig(path, dpi=dpi, metadata={"Software": None})
    with Image.open(path) as picture:
        small = picture.convert("RGB").quantize(64)
    small.save(path, optimize=True)
