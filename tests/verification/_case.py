"""Text of a case out of Python values, for studies whose scene is none of cases/."""

import json


def text(value):
    """A value as TOML: number, string, list, or a dict as an inline table."""
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {text(entry)}" for key, entry in value.items()) + " }"
    return json.dumps(value)


def case(about, name, **tables):
    """@param about   comment in the first line
    @param tables  title = dict: [title]; a list of dicts: a [[title]] each"""
    lines = [f"# {about}", f"name = {text(name)}"]
    for title, content in tables.items():
        several = isinstance(content, list)
        for table in content if several else [content]:
            lines.append(f"[[{title}]]" if several else f"[{title}]")
            lines += [f"{key} = {text(value)}" for key, value in table.items()]
    return "\n".join(lines) + "\n"


def sides(kind, **others):
    """[boundary] of two dimensions: sides of one kind, but for `others`."""
    return dict.fromkeys(("left", "right", "bottom", "top"), kind) | others


def fields(*times):
    """[output] with fields at these times."""
    return {"fields": {"times": times}}
