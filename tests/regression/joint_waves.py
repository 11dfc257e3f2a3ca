#!/usr/bin/env python3
"""A standing wave in a column of two materials, held below and free above, with explicit steps: its period is the one
of the wave equation, and its energy is kept. usage: joint_waves.py SOFTWET"""

import pathlib

import numpy
from _scene import check, check_true, history, run_file

HEIGHT, JOINT, POISSON, BEND = 1.0, 0.375, 0.3, 1e-4
MODULUS = (1 - POISSON) / ((1 + POISSON) * (1 - 2 * POISSON))  # of a confined column with young = 1


def frequency(below, above):
    """The lowest one: with the wave numbers k = w / c, u is sin(k y) below the joint and a multiple of cos(k (H - y))
    above, and tan(k_1 h_1) tan(k_2 h_2) = c_1 / c_2, as displacement and stress go on across the joint; the density is
    1."""
    low, high = 1e-6, min(below / JOINT, above / (HEIGHT - JOINT)) * numpy.pi / 2
    for _ in range(200):
        middle = 0.5 * (low + high)
        tangents = numpy.tan(middle * JOINT / below) * numpy.tan(middle * (HEIGHT - JOINT) / above)
        low, high = (middle, high) if tangents < below / above else (low, middle)
    return low


def column(rows, stiff):
    below, above = (stiff * MODULUS) ** 0.5, MODULUS**0.5
    w = frequency(below, above)
    part = numpy.sin(w * JOINT / below) / numpy.cos(w * (HEIGHT - JOINT) / above)
    return w, f"""
name = "column"
domain = {{ size = [0.25, {HEIGHT}], elements = [2, {rows}] }}
substrate = {{ thickness = {HEIGHT}, joint = {JOINT}, young = "y < {JOINT} ? {stiff} : 1", poisson = {POISSON}, strain = "small" }}
boundary = {{ left = "slip", right = "slip", bottom = "clamped", top = "free" }}
initial = {{ displacement = ["0", "{BEND} * (y < {JOINT} ? sin({w / below}*y) : {part}*cos({w / above}*({HEIGHT} - y)))"] }}
time = {{ end = {8 * numpy.pi / w} }}
output = {{ fields = {{ times = [] }}, history = {{ every = 1 }} }}
[[probe]]
name = "top"
quantity = "displacement_y"
point = [0.1, {HEIGHT}]
"""


def phase_error(scheme, mass, rows, stiff):
    w, text = column(rows, stiff)
    pathlib.Path("column.toml").write_text(text)
    run_file("column.toml", "column", [f"time.scheme={scheme}", f"time.mass={mass}"])
    found = history("column")
    energy = found["energy_total"] / found["energy_total"][0]
    check(f"{scheme}, {mass}, {rows} rows, {stiff}: energy gained, relative", energy.max() - 1, 0.01)
    top, t = found["top"] / found["top"][0], found["t"]
    cosine, sine = numpy.linalg.lstsq(numpy.stack([numpy.cos(w * t), numpy.sin(w * t)], 1)[t > 0.75 * t[-1]], top[t > 0.75 * t[-1]], rcond=None)[0]
    check(f"{scheme}, {mass}, {rows} rows, {stiff}: amplitude after four periods", abs(numpy.hypot(cosine, sine) - 1), 0.02)
    return abs(numpy.arctan2(sine, cosine)) / (8 * numpy.pi)


for stiff in (0.01, 100):
    for scheme, mass, bound in (("kick_drift", "corrected", 2e-3), ("kick_drift", "lumped", 2e-2), ("rkl2", "corrected", 2e-3)):
        coarse, fine = phase_error(scheme, mass, 8, stiff), phase_error(scheme, mass, 16, stiff)
        check(f"{scheme}, {mass}, {stiff}: frequency with 16 rows, relative", fine, bound)
        check_true(f"{scheme}, {mass}, {stiff}: it is three times better than with 8", 3 * fine < coarse or fine < 1e-5, f"{coarse:.2e} {fine:.2e}")
