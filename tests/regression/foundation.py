#!/usr/bin/env python3
"""boundary.foundation: layers on springs at rest against linear theory, in 2D and around an axis; a uniform load;
nothing feeds the energy of an explicit run; what is refused. usage: foundation.py SOFTWET"""

import subprocess

import numpy
import scipy.special
from _same import check_same
from _scene import check, check_true, environment, history, run_file, softwet
from _strip import CLOSE, FORCE, HEIGHT, LENGTH, POISSON, STRIP, YOUNG, of_strip, projected, rest, strip_load, write_layer
from _strip import _layer

K = numpy.pi / LENGTH  # 4 pi: half a wave


def springs(across, along):
    return f'bottom = "free", foundation = [{across}, {along}]'


# --- linear theory itself: numbers of an independent program
for base, value in (({"foundation": [1, 0]}, 0.340580), ({"foundation": [10, 0]}, 0.179914), ({}, 0.121149), ({"clamped": True}, 0.089743)):
    check(f"linear theory: u_y for t_y, {base or 'rollers'}",
          abs(_layer.compliance(K, HEIGHT, YOUNG, POISSON, **base)[1, 1] - value), 5e-7)

# --- 2D
sine, cosine = (lambda x: numpy.sin(K * x)), (lambda x: numpy.cos(K * x))
bases = {"on rollers": ('bottom = "slip"', {}), "clamped": ('bottom = "clamped"', {"clamped": True})}
bases |= {f"on [{across}, {along}]": (springs(across, along), {"foundation": [across, along]})
          for across, along in ((1.0, 0.0), (10.0, 0.0), (10.0, 3.0))}
bases["along rollers, 3"] = ('bottom = "slip", foundation = [0, 3]', {"foundation": [1e12, 3.0]})
for name, (boundary, base) in bases.items():
    exact, case = of_strip(K, **base), name.replace(" ", "_").replace("[", "").replace("]", "").replace(",", "")
    down = rest(write_layer(f"{case}_down", boundary=boundary, load=strip_load(LENGTH / 2, [0.0, FORCE])))
    along = rest(write_layer(f"{case}_along", boundary=boundary, load=strip_load(LENGTH, [FORCE, 0.0])))
    for run, axis, wave, column, row, of_force in ((down, "y", cosine, 1, 1, 1 / K), (along, "x", sine, 0, 0, 2 / K)):
        found = projected(run, axis, wave) / (FORCE * STRIP * of_force)
        check(f"{name}: u_{axis} for t_{'xy'[column]} is {found:.6f}, theory {exact[row, column]:.6f}, off",
              abs(found / exact[row, column] - 1), CLOSE)

# --- uniform loads: the strip, and the springs that bear it all
first, shear = _layer.lame(YOUNG, POISSON)
for coordinates, area in (("plane", LENGTH), ("axisymmetric", numpy.pi * LENGTH**2)):
    run = rest(write_layer(f"uniform_{coordinates}", boundary=springs(10.0, 2.0), load=strip_load(LENGTH, [0.0, FORCE]),
                           coordinates=coordinates))
    found = projected(run, "y", numpy.ones_like) / LENGTH / (FORCE * STRIP)
    # The strip itself is pulled by the mean of what is above each height.
    exact = (HEIGHT - STRIP / 2) / (first + 2 * shear) + 1 / 10.0
    check(f"{coordinates}, uniform: u_y is {found:.6f}, theory {exact:.6f}, off", abs(found / exact - 1), 1e-5)
    energy = run.history["energy_foundation"][-1]
    check(f"{coordinates}: energy of the springs, off", abs(energy / (0.5 * (FORCE * STRIP)**2 / 10.0 * area) - 1), 1e-5)

# --- around an axis: a vertical force on a disc, and the first wave J_0 of the vertical displacement
k, disc = scipy.special.jn_zeros(1, 1)[0] / LENGTH, LENGTH / 2
run = rest(write_layer("around", boundary=springs(10.0, 3.0), load=strip_load(disc, [0.0, FORCE]), coordinates="axisymmetric"))
found = projected(run, "y", lambda r: scipy.special.j0(k * r), weight=lambda r: r)
found /= FORCE * STRIP * disc * scipy.special.j1(k * disc) / k
exact = of_strip(k, foundation=[10.0, 3.0])[1, 1]
check(f"around an axis: u_z for t_z is {found:.6f}, theory {exact:.6f}, off", abs(found / exact - 1), CLOSE)

# --- an explicit run on stiff springs: the swing of the energy falls with the square of the step
WAVES = '[initial]\ndisplacement = ["0.004*sin(2*pi*x/Lx)*y/H", "0.003*cos(2*pi*2*x/Lx) + 0.002"]\n'
swings = {}
for name, safety in (("whole", 0.8), ("half", 0.4)):
    case = write_layer("swings", boundary=springs(20.0, 5.0), more=WAVES, elements=(16, 8),
                       time=f'time = {{ end = 1.0, scheme = "kick_drift", mass = "consistent", safety = {safety} }}')
    run_file(case, name)
    rows = history(name)
    energy, of_springs = rows["energy_total"], rows["energy_foundation"]
    swings[name] = energy.max() / energy.min() - 1
    check_true(f"{name}: energy that the springs take and give, of the whole",
               (of_springs.max() - of_springs.min()) > 0.1 * energy[0], f"{(of_springs.max() - of_springs.min()) / energy[0]:.2f}")
check("largest energy over the smallest, less 1", swings["whole"], 0.02)
check("the same with half the step, over that: second order", swings["half"] / swings["whole"], 0.3)

run_file(case, "parts", ["time.max_steps=100"])
run_file(case, "parts", options=("--resume", "--quiet", "--threads", "1"))
check_same("a resumed run", "parts", "half")

# --- what is refused
for boundary, words in (('bottom = "clamped", foundation = [1, 0]', ("boundary.foundation", "clamped", 'bottom = "free"')),
                        ('bottom = "slip", foundation = [1, 2]', ("boundary.foundation", "slip", "[0, 2]")),
                        ('bottom = "free", foundation = [1]', ("boundary.foundation", "2 numbers")),
                        ('bottom = "free", foundation = [-1, 0]', ("boundary.foundation", "[0, inf)"))):
    done = subprocess.run([softwet, "check", write_layer("refused", boundary=boundary)], capture_output=True, text=True, timeout=900,
                          env=environment)
    check_true(f"{boundary}: refused", done.returncode == 1 and all(word in done.stderr for word in words), done.stderr.strip())
