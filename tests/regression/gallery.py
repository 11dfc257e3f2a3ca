#!/usr/bin/env python3
"""Every case stands in docs/gallery.md with its picture and its commands, and one that does not is named.
usage: gallery.py SOFTWET"""

import importlib.util
import os
import pathlib
import runpy
import shutil
import subprocess
import sys

from _scene import check_true

ROOT = pathlib.Path(os.environ["SOFTWET_SOURCE_DIR"])


def check(root):
    return subprocess.run([sys.executable, str(root / "tools/gallery"), "--check"], capture_output=True, text=True)


result = check(ROOT)
check_true("every case has a section and a picture", result.returncode == 0, result.stderr)

# A copy in which each kind of mistake is made once.
copy = pathlib.Path("copy").resolve()
shutil.rmtree(copy, ignore_errors=True)
for folder in ("cases", "tools", "docs/gallery"):
    shutil.copytree(ROOT / folder, copy / folder, ignore=shutil.ignore_patterns("__pycache__"))
page = (ROOT / "docs/gallery.md").read_text()
(copy / "docs/gallery.md").write_text(page.replace("### stripe_2d", "### strip_2d", 1))
(copy / "docs/gallery/fibres_2d.png").unlink()
(copy / "docs/gallery/durotaxis_2d.png").write_bytes(bytes(50_000))
told = check(copy).stderr
for sentence in ("cases/stripe_2d.toml has no section", "a section strip_2d, and cases/ has no such case",
                 "docs/gallery/fibres_2d.png is missing", "docs/gallery/stripe_2d.png belongs to no section",
                 "docs/gallery/durotaxis_2d.png has 50000 bytes"):
    check_true(f"reported: {sentence}", sentence in told, told)

# Two shades on white paper: in each block of 20 x 10 pixels the mean of the reduced picture is the shade's, as it is
# not in bands.
if importlib.util.find_spec("PIL") is None or importlib.util.find_spec("numpy") is None:
    sys.exit(print("no PIL or no numpy: no picture is reduced") or 0)
import numpy  # noqa: E402
from PIL import Image  # noqa: E402

x, pixels = numpy.linspace(0, 1, 720), numpy.full((300, 720, 3), 255.0)
for rows, dark in ((slice(20, 140), [8, 48, 107]), (slice(160, 280), [45, 0, 75])):
    pixels[rows] = numpy.floor(255 * (1 - x)[:, None] + x[:, None] * dark)
Image.fromarray(pixels.astype("uint8")).save("shades.png")
runpy.run_path(str(ROOT / "tools" / "gallery"))["reduce"](pathlib.Path("shades.png"), pathlib.Path("reduced.png"))
reduced = numpy.asarray(Image.open("reduced.png").convert("RGB"), dtype=float)
blocks = abs((reduced - pixels).reshape(15, 20, 72, 10, 3).mean(axis=(1, 3))).max()
check_true("a reduced picture has no bands", blocks < 3, f"{blocks} of 255")
check_true("and white paper", (reduced[:20] == 255).all())
