#!/usr/bin/env python3
"""`softwet init --like SCENE` writes a short case that `softwet check` accepts without a warning. usage: start_cases.py SOFTWET"""

import pathlib
import subprocess
import tomllib

from _scene import check_true, environment, softwet


def call(*words, code=0):
    done = subprocess.run([softwet, *words], capture_output=True, text=True, timeout=900, env=environment)
    check_true(f"{' '.join(words)}: exit code {code}", done.returncode == code, done.stderr)
    return done.stdout, done.stderr


def has_configuration(name):
    return "built" in call("run", name, "--needs")[0]


HAS = {"gel": ("laboratory", "fluid", "substrate", "droplet"), "pattern": ("fluid", "droplet"), "needle": ("laboratory", "substrate", "needle"),
       "impact": ("fluid", "substrate", "droplet"), "3d": ("fluid", "droplet"), "pull": ("substrate", "load")}
for scene, tables in HAS.items():
    name = f"my_{scene}.toml"
    pathlib.Path(name).unlink(missing_ok=True)
    call("init", name, "--like", scene)
    text = pathlib.Path(name).read_text()
    case = tomllib.loads(text)
    check_true(f"{scene}: its name and tables", case["name"] == f"my_{scene}" and set(tables) <= set(case), str(list(case)))
    check_true(f"{scene}: the rules for editors", text.startswith("#:schema softwet.schema.json\n"))
    lines = len(text.splitlines())
    check_true(f"{scene}: {lines} lines", lines > 100 if scene == "pull" else 25 <= lines <= 48)
    if has_configuration(name) and scene != "pull":  # the model of the paper, whose ridge depends on the width
        warned = call("check", name)[1]
        check_true(f"{scene}: no warning", not warned, warned)

# --- what they are of
sizes = {scene: len(tomllib.loads(pathlib.Path(f"my_{scene}.toml").read_text())["domain"]["size"]) for scene in HAS}
check_true("3d alone is in 3D", [scene for scene, size in sizes.items() if size == 3] == ["3d"], str(sizes))
pathlib.Path("softwet.toml").unlink(missing_ok=True)
call("init")
gel = pathlib.Path("my_gel.toml").read_text()
check_true("init alone writes the gel", pathlib.Path("softwet.toml").read_text() == gel.replace('"my_gel"', '"softwet"'))
said = call("init", "other.toml", "--like", "beam", code=1)[1]
check_true("a scene that there is not", "pattern" in said and not pathlib.Path("other.toml").exists(), said)
said = call("init", "my gel.toml", code=1)[1]
check_true("a name that no case can have", "letters, digits" in said and not pathlib.Path("my gel.toml").exists(), said)
