#!/usr/bin/env python3
"""The site of the documentation builds without a warning, holds every page, can be searched, and all its links lead
somewhere.
usage: site.py SOFTWET

mkdocs.yml and tools/site.py make it from docs/ and README.md. Checked are the pages as a browser gets them: files and
anchors that links and pictures name. Without MkDocs or its theme Material nothing is tested, and the output names what
is missing."""

import html.parser
import importlib.util
import json
import os
import pathlib
import shutil
import subprocess
import sys
import urllib.parse

from _scene import check_true

ROOT = pathlib.Path(os.environ["SOFTWET_SOURCE_DIR"])
MOST_ENTRIES = 8  # at the top of the navigation

for module, package in (("mkdocs", "mkdocs"), ("pymdownx", "python3-pymdownx")):
    if not importlib.util.find_spec(module):
        sys.exit(print(f"no site is built here: the Python module {module} is missing; on Debian: apt-get install {package}"))
from mkdocs import utils  # noqa: E402

if "material" not in utils.get_theme_names():
    sys.exit(print("no site is built here: the theme Material of MkDocs is missing; on Debian: apt-get install mkdocs-material"))
import yaml  # noqa: E402

sys.path.insert(0, str(ROOT / "tools"))
import site_links  # noqa: E402


class Page(html.parser.HTMLParser):
    """What a page names (`targets`), and what others may name in it (`anchors`)."""

    def __init__(self, path):
        super().__init__()
        self.targets, self.anchors = [], set()
        self.feed(path.read_text())

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("id", "name") and value:
                self.anchors.add(value)
            if (tag, name) in (("a", "href"), ("img", "src")) and value:
                self.targets.append(value)


def build(config, out):
    shutil.rmtree(out, ignore_errors=True)
    return subprocess.run([sys.executable, "-m", "mkdocs", "build", "--strict", "--config-file", config, "--site-dir", out],
                          capture_output=True, text=True)


def broken(site):
    """Links and pictures of a site that lead nowhere."""
    pages = {path: Page(path) for path in site.rglob("*.html") if path.name != "404.html"}
    found = []
    for path, page in pages.items():
        for target in page.targets:
            parts = urllib.parse.urlsplit(target)
            if parts.scheme or parts.netloc:
                continue
            goal = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
            goal = goal / "index.html" if goal.is_dir() else goal
            anchor = urllib.parse.unquote(parts.fragment)
            if not goal.is_file() or (anchor and goal in pages and anchor not in pages[goal].anchors):
                found.append(f"{path.relative_to(site)}: {target}")
    return found


def pages_of(nav):
    for entry in nav:
        for value in entry.values():
            yield from [value] if isinstance(value, str) else pages_of(value)


def copy_of_sources(folder):
    """A small copy with a page, a broken link and a link to a file beside docs/."""
    shutil.rmtree(folder, ignore_errors=True)
    (folder / "docs").mkdir(parents=True)
    (folder / "tools").mkdir()
    for name in ("mkdocs.yml", "CITATION.cff", "tools/site_links.py"):
        shutil.copy(ROOT / name, folder / name)
    settings = (folder / "mkdocs.yml").read_text().split("nav:\n")[0]
    (folder / "mkdocs.yml").write_text(settings + "nav:\n  - softwet: README.md\n  - One: one.md\n")
    (folder / "README.md").write_text("# Front\n\n[one](docs/one.md#a-b), [the licence](LICENSE), `[code](LICENSE)`\n")
    (folder / "docs/README.md").write_text("# Not in the site\n")
    (folder / "docs/one.md").write_text("# One\n\n## A b\n\n[up](../README.md), [front](README.md), [source](../tools/site_links.py)\n")
    return folder


# the rules for links, on their own
links = site_links.with_links
check_true("a link of the README leads into docs", links("[a](docs/b.md#c)", "", "") == "[a](b.md#c)")
check_true("a picture of the README too", links("![a](docs/b.png)", "", "") == "![a](b.png)")
check_true("a link out of docs without an address is text", links("[`a`](../LICENSE)", "docs", "") == "`a`")
there = links("[a](../../LICENSE), [b](../../tools)", "docs/development", "https://x.org/s")
check_true("and with an address a link there",
           there == "[a](https://x.org/s/blob/main/LICENSE), [b](https://x.org/s/tree/main/tools)", there)
check_true("code stays", links("`[a](LICENSE)`", "", "") == "`[a](LICENSE)`")

# the site
site = pathlib.Path("site").resolve()
built = build(ROOT / "mkdocs.yml", site)
check_true("mkdocs build --strict", built.returncode == 0, built.stderr if built.returncode else "")
nav = yaml.unsafe_load((ROOT / "mkdocs.yml").read_text())["nav"]
check_true(f"at most {MOST_ENTRIES} entries at the top", len(nav) <= MOST_ENTRIES, len(nav))
pages = {path.relative_to(ROOT / "docs").as_posix() for folder in ("", "development") for path in (ROOT / "docs" / folder).glob("*.md")}
check_true("every page has its place", set(pages_of(nav)) == pages, sorted(set(pages_of(nav)) ^ pages))
check_true("all links and pictures lead somewhere", not broken(site), "\n".join(broken(site)))
entries = json.loads((site / "search/search_index.json").read_text())["docs"]
check_true("the search knows a key", any("elastocapillary length" in entry["text"] for entry in entries), len(entries))
check_true("the front page is the README", "softwet computes droplets on soft solids" in (site / "index.html").read_text())

# mistakes are found
small = copy_of_sources(pathlib.Path("small").resolve())
built = build(small / "mkdocs.yml", small / "out")
check_true("a small site builds", built.returncode == 0 and not broken(small / "out"), broken(small / "out"))
(small / "docs/one.md").write_text("# One\n\n[gone](gone.md)\n")
built = build(small / "mkdocs.yml", small / "out")
check_true("a link to a page that is gone fails", built.returncode != 0 and "gone.md" in built.stderr)
(small / "docs/one.md").write_text("# One\n\n[gone](README.md#gone)\n")
built = build(small / "mkdocs.yml", small / "out")
check_true("so does an anchor that is gone", broken(small / "out"))
