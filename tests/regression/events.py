#!/usr/bin/env python3
"""A droplet that vanishes, reaches a side or merges is reported once: on stderr, in run.json and in the closing line.
usage: events.py SOFTWET"""

import pathlib

from _scene import check_true, record, run, run_file

ALOUD = ["--overwrite", "--threads", "1"]
SMALL = ["domain.size=[0.5,0.25]", "domain.elements=[32,16]", "fluid.capillarity=1/32", "output.fields.times=[]"]


def what(folder):
    return [event["what"] for event in record(folder)["events"]]


def told(name, message, folder, sentences):
    """Each sentence stands in run.json once, on a line of stderr of its own, and in the closing line."""
    check_true(f"{name}: run.json", what(folder) == sentences, str(what(folder)))
    lines = [line for line in message.splitlines() if line.startswith("softwet: ") and "warning" not in line]
    for sentence in sentences:
        own = [line for line in lines if line.startswith("softwet: at t = ") and line.endswith(sentence)]
        check_true(f"{name}: reported once", len(own) == 1, str(own))
        check_true(f"{name}: in the closing line", own[0].removeprefix("softwet: ") in lines[-1], lines[-1])


# Smaller than its interface is wide: it evaporates, and the run goes on to its end.
TINY = SMALL + ["droplet[0].radius=0.03", "droplet[0].centre=[0.25,0]", "time.end=20"]
GONE = ["the droplet vanished: no liquid is left, and the run goes on with vapour alone"]
message = run("static_droplet_rigid_2d", "tiny", TINY, ALOUD)
told("tiny", message, "tiny", GONE)
stop = record("tiny")["stop"]
check_true("tiny: the end is reached all the same", stop["reason"] == "end reached" and stop["t"] == 20, str(stop))
check_true("tiny: the time of the event", 0 < record("tiny")["events"][0]["t"] < 20)

# What happened before a checkpoint is known after it, and not reported again.
run("static_droplet_rigid_2d", "resumed", TINY + [f"time.max_steps={record('tiny')['counts']['steps'] - 3}"])
check_true("before the resume", what("resumed") == GONE, str(what("resumed")))
message = run("static_droplet_rigid_2d", "resumed", TINY, ["--resume", "--threads", "1"])
check_true("after the resume: run.json", record("resumed")["events"][0] == record("tiny")["events"][0] and what("resumed") == GONE)
check_true("after the resume: in the closing line alone", message.count(GONE[0]) == 1, message)
check_true("quiet is silent", run("static_droplet_rigid_2d", "quiet", TINY).count("vanished") == 0)

# A round droplet over a wall that it wets, in a box it fills when it spreads; and half a droplet, which stays.
SPREADS = SMALL + ["domain.size=[0.25,0.25]", "domain.elements=[16,16]", "fluid.contact_angle=30",
                   "fluid.temperature=0.6", "droplet[0].radius=0.09", "droplet[0].centre=[0.125,0.1]", "time.end=20"]
message = run("static_droplet_rigid_2d", "spreads", SPREADS, ALOUD)
told("spreads", message, "spreads", ["the droplet reached the wall", "the droplet reached the left side", "the droplet reached the right side"])
run("static_droplet_rigid_2d", "half", SMALL + ["droplet[0].radius=0.155", "droplet[0].centre=[0,0]", "time.end=5"])
check_true("half a droplet is no event", what("half") == [], str(what("half")))

# Two caps side by side, too steep for their contact angle: they spread.
pathlib.Path("pair.toml").write_text("""
name = "pair"
domain = { size = [0.5, 0.25], elements = [32, 16] }
fluid = { viscosity = "1/256", capillarity = "1/32", temperature = 0.39, contact_angle = 60 }
time.end = 1
[[droplet]]
centre = [0.15, 0]
radius = 0.08
stretch = [1, 1.4]
[[droplet]]
centre = [0.34, 0]
radius = 0.08
stretch = [1, 1.4]
""")
told("pair", run_file("pair.toml", "pair", [], ALOUD), "pair", ["droplet 1 and droplet 2 merged"])
