"""Devices of members that run side by side."""

import contextlib
import os
import re
import shutil
import subprocess
import tempfile

from .._tools.messages import fail, say

VISIBLE = {"Cuda": "CUDA_VISIBLE_DEVICES", "HIP": "ROCR_VISIBLE_DEVICES"}  # what limits a process to some devices
MPS = "nvidia-cuda-mps-control"


def backend_of(program):
    """@return the backend of a program, e.g. "OpenMP" or "Cuda", and the number of devices that it sees"""
    done = subprocess.run([str(program), "info"], capture_output=True, text=True)
    name = re.search(r"\bbackend +(\w+)", done.stdout + done.stderr)  # where it finds no device, the message names it
    count = re.search(r"^devices +(\d+)", done.stdout, re.M)
    return name[1] if name else "", int(count[1]) if count else 0


class Devices:
    """Gives each running member the device with the fewest members. A program for processors has none, and nothing is
    limited.
    @param per_device  members that share a device at most"""

    def __init__(self, program, per_device=1):
        backend, count = backend_of(program)
        self.variable, self.per_device = VISIBLE.get(backend), per_device
        if not self.variable:
            count = 0
        listed = [name for name in os.environ.get(self.variable or "", "").split(",") if name]
        self.members = dict.fromkeys(listed[:count] or map(str, range(count)), 0)

    def room(self):
        """Members at once, or None where nothing limits them."""
        return len(self.members) * self.per_device if self.variable else None

    def take(self):
        """@return a device for one more member, or None on a processor"""
        if not self.members:
            return None
        device = min(self.members, key=self.members.get)
        self.members[device] += 1
        return device

    def give_back(self, device):
        if device is not None:
            self.members[device] -= 1

    def environment(self, device):
        """What a member's environment has more, so that it sees its device alone."""
        return {} if device is None else {self.variable: device}


def check_room(devices, jobs, option=True):
    """Refuses more members at once than devices have room for. @param option  the command has --per-device"""
    room = devices.room()
    if room == 0:
        fail(f"no device is visible to the program; see {devices.variable}", 3)
    if room and jobs > room:
        share = f", or --per-device {-(-jobs // len(devices.members))} to let members share devices" if option else ""
        fail(f"--jobs {jobs}: there are {len(devices.members)} devices with {devices.per_device} member each at most; "
             f"give --jobs {room}{share}")


@contextlib.contextmanager
def sharing(devices):
    """Runs NVIDIA's Multi-Process Service where members share devices, so that their kernels run side by side. One that
    runs already serves them too."""
    wanted = devices.variable == VISIBLE["Cuda"] and devices.per_device > 1
    if not wanted or "CUDA_MPS_PIPE_DIRECTORY" in os.environ:
        yield {}
        return
    if not shutil.which(MPS):
        say(f"{MPS} is not on PATH: members that share a device take turns on it")
        yield {}
        return
    with tempfile.TemporaryDirectory(prefix="softwet-mps-") as folder:
        words = {"CUDA_MPS_PIPE_DIRECTORY": folder, "CUDA_MPS_LOG_DIRECTORY": folder}
        environment = {**os.environ, **words}
        if subprocess.run([MPS, "-d"], env=environment).returncode:
            say(f"{MPS} did not start: members that share a device take turns on it")
            yield {}
            return
        try:
            yield words
        finally:
            subprocess.run([MPS], input="quit\n", text=True, env=environment, stdout=subprocess.DEVNULL)
