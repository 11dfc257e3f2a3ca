#!/usr/bin/env python3
"""Members of a sweep on several GPUs. A stub stands for the program: it says that it sees two devices, and its runs
note which of them they were given, how many ran at once on each, and whether they share it.
usage: sweep_devices.py SOFTWET"""

import os
import pathlib
import re
import shutil
import subprocess

from _scene import cases, check_true, environment, softwet

CASE = str(cases / "solid_layer_2d.toml")
VALUES = "substrate.poisson=0.1:0.4:6"
NOTES = pathlib.Path("notes").absolute()
COUNT = pathlib.Path("devices").absolute()
STUB = f"""#!/usr/bin/env bash
if [ "$1" = info ]; then
  [ "$(cat {COUNT})" -gt 0 ] || {{ echo "softwet: error: the backend Cuda finds no device" >&2; exit 3; }}
  {softwet} info | sed "s/^backend.*/backend         Cuda, 1 threads\\ndevices         $(cat {COUNT})/"
elif [ "$1" = run ] && [[ " $* " == *" --out "* ]]; then
  echo "begin $CUDA_VISIBLE_DEVICES ${{CUDA_MPS_PIPE_DIRECTORY:-alone}}" >> {NOTES}
  sleep 0.3
  {softwet} "$@"
  code=$?
  echo "end $CUDA_VISIBLE_DEVICES" >> {NOTES}
  exit $code
else
  exec {softwet} "$@"
fi
"""
CONTROL = f"""#!/usr/bin/env bash
if [ "$1" = -d ]; then echo "service $CUDA_MPS_PIPE_DIRECTORY" >> {NOTES}; else read -r word; echo "service $word" >> {NOTES}; fi
"""


def program(path, text):
    path.write_text(text)
    path.chmod(0o755)
    return path.absolute()


def sweep(*options, code=0, **variables):
    shutil.rmtree("out", ignore_errors=True)
    NOTES.unlink(missing_ok=True)
    surroundings = {key: value for key, value in environment.items() if key != "CUDA_VISIBLE_DEVICES"}
    done = subprocess.run([str(stub.parent.parent / "tool"), CASE, "--softwet", str(stub), "--vary", VALUES, "--out", "out", *options,
                           "--set", "domain.elements=[16,4]", "--set", "time.max_steps=2", "--set", "output.fields.times=[]"],
                          capture_output=True, text=True, timeout=900, env={**surroundings, **variables})
    check_true(f"exit code {code} of {' '.join(options)}", done.returncode == code, done.stdout + done.stderr)
    return done, NOTES.read_text().splitlines() if NOTES.exists() else []


def started(done):
    """Devices of members in the order in which they were started."""
    return re.findall(r"started on device (\d+)", done.stdout)


def most_at_once(notes):
    """{device: most members that ran on it at once}"""
    running, most = {}, {}
    for what, device, *_ in (note.split() for note in notes if not note.startswith("service")):
        running[device] = running.get(device, 0) + (1 if what == "begin" else -1)
        most[device] = max(most.get(device, 0), running[device])
    return most


folder = pathlib.Path("bin")
folder.mkdir(exist_ok=True)
stub = program(folder / "softwet", STUB)
tool = pathlib.Path("tool")
tool.unlink(missing_ok=True)
tool.symlink_to(pathlib.Path(os.environ["SOFTWET_SOURCE_DIR"]) / "tools" / "sweep")

COUNT.write_text("2")
done, notes = sweep("--jobs", "2")
check_true("each running member has a device of its own", most_at_once(notes) == {"0": 1, "1": 1}, notes)
check_true("the output says which", started(done)[:2] == ["0", "1"], done.stdout)
_, notes = sweep("--jobs", "2", CUDA_VISIBLE_DEVICES="5,7")
check_true("they are among those that are visible", most_at_once(notes) == {"5": 1, "7": 1}, notes)

done, notes = sweep("--jobs", "4", code=1)
check_true("more members than devices are refused", "--jobs 2" in done.stderr and "--per-device 2" in done.stderr and not notes, done.stderr)
control = program(folder / "nvidia-cuda-mps-control", CONTROL)
shared = {"PATH": f"{folder.absolute()}:{os.environ['PATH']}"}
done, notes = sweep("--jobs", "4", "--per-device", "2", **shared)
check_true("two members share each device", started(done)[:4] == ["0", "1", "0", "1"], done.stdout)
check_true("and no more", max(most_at_once(notes).values()) <= 2, notes)
place = notes[0].removeprefix("service ")
check_true("by a service that is started and ended", notes[-1] == "service quit" and all(
    note.endswith(place) for note in notes if note.startswith("begin")), notes)
control.unlink()
done, notes = sweep("--jobs", "4", "--per-device", "2")
check_true("without the service the output says so", "nvidia-cuda-mps-control" in done.stdout and started(done)[:4] == ["0", "1", "0", "1"],
           done.stdout)

script = pathlib.Path("array.sh")
script.unlink(missing_ok=True)
for count in ("2", "0"):  # a login node sees no device
    COUNT.write_text(count)
    sweep("--slurm", "array.sh")
    check_true(f"the script asks for a device, written where there are {count}", "#SBATCH --gpus-per-task=1\n" in script.read_text())
done, _ = sweep("--jobs", "1", code=3)
check_true("no device, no run", "CUDA_VISIBLE_DEVICES" in done.stderr, done.stderr)

plain = subprocess.run([softwet, "sweep", CASE, "--vary", "substrate.poisson=0.1,0.2", "--out", "plain", "--slurm", "plain.sh"],
                       capture_output=True, text=True, env=environment)
check_true("a program for processors asks for none", plain.returncode == 0 and not re.search("gpu", pathlib.Path("plain.sh").read_text()))
