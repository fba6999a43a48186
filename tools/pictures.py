# SPDX-License-Identifier: MIT
"""Pictures that the documentation keeps: small ones."""
from PIL import Image


def save_png(figure, path, dpi):
    """Draws a matplotlib figure as a PNG of 64 colours, a quarter of the size that matplotlib's own has."""
    figure.savefig(path, dpi=dpi, metadata={"Software": None})
    with Image.open(path) as picture:
        small = picture.convert("RGB").quantize(64)
    small.save(path, optimize=True)
