"""What mkdocs.yml does to the pages of docs/, so that their links work on the forge and in the site.

The front page of the site is README.md of the repository, in place of docs/README.md, whose table is the navigation. A
link that leaves docs/ leads to the file at the address `repository-code` of CITATION.cff; where there is no address,
its text stays and the link goes."""

import pathlib
import posixpath
import re

import yaml

ROOT = pathlib.Path(__file__).resolve().parents[1]
CODE = re.compile(r"(^ *```.*?^ *```|`[^`\n]*`)", re.DOTALL | re.MULTILINE)
LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)\s]+)\)")


def address():
    """Where the repository is, from CITATION.cff; empty where it is not known."""
    return yaml.safe_load((ROOT / "CITATION.cff").read_text()).get("repository-code", "").rstrip("/")


def leads_to(folder, target, repository):
    """What a link of a page in `folder` becomes in the site: a path from that folder, or an address; None where it
    leads nowhere."""
    if re.match(r"[a-z]+:|#", target):
        return target
    path, _, anchor = target.partition("#")
    place = posixpath.normpath(posixpath.join(folder, path))
    if place == "docs" or place.startswith("docs/"):
        inside = posixpath.relpath(place, folder if folder.startswith("docs") else "docs")
        return inside + (f"#{anchor}" if anchor else "")
    if place == "README.md":
        return posixpath.relpath("docs/README.md", folder)
    kind = "tree" if (ROOT / place).is_dir() else "blob"
    return f"{repository}/{kind}/main/{place}" if repository else None


def with_links(text, folder, repository):
    """The text of a page in `folder`, with links that work in the site; code stays as it is."""
    def link(found):
        mark, words, target = found.groups()
        goal = leads_to(folder, target, repository)
        return words if goal is None else f"{mark}[{words}]({goal})"

    pieces = CODE.split(text)
    # a link may hold code, as [`name`](place) does: look at texts with such pieces between them as one
    joined, kept = "", []
    for index, piece in enumerate(pieces):
        if index % 2:
            kept.append(piece)
            piece = f"\0{len(kept) - 1}\0"
        joined += piece
    joined = LINK.sub(link, joined)
    return re.sub(r"\0(\d+)\0", lambda found: kept[int(found.group(1))], joined)


def on_page_read_source(page, config, **_):
    """The README of the repository for the front page."""
    return (ROOT / "README.md").read_text() if page.file.src_path == "README.md" else None


def on_page_markdown(markdown, page, config, **_):
    front = page.file.src_path == "README.md"
    folder = "" if front else posixpath.join("docs", posixpath.dirname(page.file.src_path)).rstrip("/")
    return with_links(markdown, folder, address())
