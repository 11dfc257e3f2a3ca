#!/usr/bin/env python3
"""A checkpoint of four processes is one of any number: runs that go on from it agree in every bit. And the other way
round.
usage: resume.py SOFTWET"""

import shutil

from _ranks import check_same, run

SCENE = ["domain.elements=[44,16]", "fluid.capillarity=1/16", "load[0].start=2", "load[0].ramp=1",
         "output.fields.times=[]"]
MORE = ("--resume", "--quiet")

for written in (4, 1):
    run(written, "tensotaxis_pull_2d", f"part_{written}", [*SCENE, "time.max_steps=6"])
    for count in (1, 2, 3):
        folder = f"from_{written}_on_{count}"
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(f"part_{written}", folder)
        run(count, "tensotaxis_pull_2d", folder, [*SCENE, "time.max_steps=12"], MORE)
    for count in (2, 3):
        check_same(f"from {written} on {count}", f"from_{written}_on_{count}", f"from_{written}_on_1")
check_same("from 4 and from 1", "from_4_on_2", "from_1_on_2")
