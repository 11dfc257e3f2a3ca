#!/usr/bin/env python3
"""One and two threads give identical bits. usage: threads.py SOFTWET"""

from _same import arrays, check_same
from _scene import PULL, check_true, run

SETTINGS = PULL + ["time.end=4", "output.fields.times=[0,4]"]
for count in (1, 2, 3):
    run("tensotaxis_pull_2d", f"threads_{count}", SETTINGS, ["--overwrite", "--quiet", "--threads", str(count)])
one = arrays("threads_1/checkpoint.h5")
check_true("the checkpoint has arrays", len(one) >= 7, str(sorted(one)))
for count in (2, 3):
    check_same(f"{count} threads", f"threads_{count}", "threads_1")
