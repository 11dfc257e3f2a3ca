#!/usr/bin/env python3
"""`softwet bench --preconditioners` compares what it says it does. usage: bench_preconditioners.py SOFTWET"""

import re
import subprocess

from _scene import cases, check_true, environment, softwet

answer = subprocess.run(
    [softwet, "bench", str(cases / "tensotaxis_pull_2d.toml"), "--preconditioners", "--threads", "1",
     "--set", "domain.elements=[48,24]", "--set", "fluid.capillarity=1/24"],
    capture_output=True, text=True, env=environment)
check_true("it ends well", answer.returncode == 0, answer.stderr)
print(answer.stdout)

# A line: name, seconds of a build, MiB, milliseconds of an iteration; then four counts for each of three time steps.
rows = {}
for line in answer.stdout.splitlines():
    found = re.match(r"(\S.*?) +([\d.]+) s +(\d+) +([\d.]+) ms +((?:[-\d]+ *){12})$", line)
    if found:
        counts = [float(word.replace("-", "inf")) for word in found[5].split()]
        rows[found[1]] = [counts[i:i + 4] for i in (0, 4, 8)]
check_true("all forms have a row", {"lu", "schwarz", "schwarz, without coarse levels"} <= rows.keys(), str(rows.keys()))
check_true("a tighter solve takes no fewer iterations",
           all(0 < loose <= tight for steps in rows.values() for loose, tight, *_ in steps), str(rows))
for k in range(3):
    check_true("factors take the fewest iterations", rows["lu"][k][1] <= rows["schwarz"][k][1])
# Not at dt = 10: there boxes take 50 to 160 iterations, depending on round-off.
check_true("coarse levels help at dt = 1", rows["schwarz"][1][1] < 0.8 * rows["schwarz, without coarse levels"][1][1])
lagged = [step[2:] for steps in rows.values() for step in steps]
check_true("a preconditioner of another step is better when it is fitted to the solid",
           sum(fitted < plain for plain, fitted in lagged) > 2 * sum(fitted > plain for plain, fitted in lagged),
           str(lagged))
