#!/usr/bin/env python3
"""Every case stands in docs/gallery.md with its picture and its commands, and one that does not is named.
usage: gallery.py SOFTWET"""

import os
import pathlib
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
