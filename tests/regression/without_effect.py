#!/usr/bin/env python3
"""What would have no effect is reported: keys whose owner is missing, a film outside of the fluid, keys that no state
of rest depends on.
usage: without_effect.py SOFTWET"""

import pathlib
import shutil
import subprocess

from _scene import cases, check_true, environment, softwet

RIGID, SOFT, LAYER = (str(cases / f"{name}.toml") for name in ("static_droplet_rigid_2d", "static_droplet_soft_2d", "solid_layer_2d"))


def call(command, case, *settings, options=(), code=0):
    words = [softwet, command, case, *(word for setting in settings for word in ("--set", setting)), *options]
    done = subprocess.run(words, capture_output=True, text=True, timeout=900, env=environment)
    check_true(f"{command} {settings} {options}: exit code {code}", done.returncode == code, done.stdout + done.stderr)
    return done.stderr


# Keys whose owner is missing.
for case, setting, parts in ((RIGID, "fluid.creep_speed=0.01", ("fluid.creep_speed = 0.01", "contact_angle_range = [65, 85]", "[0, 180]")),
                             (LAYER, "substrate.fibre.angle=30", ("substrate.fibre.angle = 30", "fibre.stiffness")),
                             (LAYER, "substrate.gel.time=0.3", ("substrate.gel.time = 0.3", "gel.exponent", "(0, 1)")),
                             (LAYER, "substrate.gel.decades=[-1,3]", ("substrate.gel.decades = [-1, 3]", "gel.exponent"))):
    said = call("check", case, setting)
    check_true(f"{setting} alone", all(part in said for part in (*parts, "has no effect")), said)
idle = "has no effect"
check_true("the defaults are silent", idle not in call("check", RIGID, "fluid.creep_speed=1e-4") + call("check", LAYER))
lines = pathlib.Path(RIGID).read_text().splitlines()
pathlib.Path("range.toml").write_text("\n".join(line for line in lines if not line.startswith("contact_angle")))
said = call("check", "range.toml", "fluid.contact_angle_range=[65,85]", "fluid.wall_law=energy", "fluid.creep_speed=0.01")
check_true("so is a speed of creep beside its range", idle not in said, said)
said = call("check", LAYER, "substrate.fibre.stiffness=1", "substrate.fibre.angle=30", "substrate.gel.exponent=0.5", "substrate.gel.time=0.3")
check_true("and what belongs to something", idle not in said, said)

# Films; the fluid of the second case begins above a solid.
for case, box, parts in ((RIGID, "[[1.2,0],[1.5,0.2]]", ("[1.2, 1.5] along axis 0", "[0, 1]")), (RIGID, "[[0.1,0.6],[0.4,0.7]]", ("[0.6, 0.7] along axis 1",)),
                         (RIGID, "[[-0.5,0],[0,0.2]]", ("[-0.5, 0] along axis 0",)), (SOFT, "[[0.1,0],[0.4,0.1]]", ("[0, 0.1] along axis 1", "[0.125, 0.5]"))):
    pathlib.Path("film.toml").write_text(pathlib.Path(case).read_text() + f"\n[[film]]\nbox = {box}\n")
    said = call("check", "film.toml", code=1)
    check_true(f"a film in {box}", all(part in said for part in ("film.toml", "film[0].box", *parts, "outside of the fluid", "move the box")), said)
pathlib.Path("film.toml").write_text(pathlib.Path(SOFT).read_text() + "\n[[film]]\nbox = [[-0.5, -0.1], [0.1, 0.2]]\n")
call("check", "film.toml")

# Keys of `steady --along`.
small = ["domain.elements=[16,4]", "output.fields.times=[]"]
shutil.rmtree("along", ignore_errors=True)
for key, why in (("output.history.every", "output"), ("substrate.branch[0].modulus", "branches"), ("fluid.creep_speed", "hysteresis"), ("probe[0].point", "probe")):
    said = call("steady", LAYER, *small, options=["--along", f"{key}=1,2", "--out", "along"], code=1)
    check_true(f"--along {key} is refused", f"--along {key}" in said and why in said and "softwet sweep" in said, said)
check_true("and nothing is written", not pathlib.Path("along").exists())
ways = {"solver.krylov.max": True, "substrate.young": False}
for key, silent in ways.items():
    values = "150,180" if silent else "1,0.9"
    said = call("steady", LAYER, *small, options=["--along", f"{key}={values}", "--out", "along", "--overwrite", "--threads", "1"])
    check_true(f"--along {key}", (f"--along {key}={values}: {key} has no effect here" in said) == silent, said)
