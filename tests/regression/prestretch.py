#!/usr/bin/env python3
"""Layers that are stretched before the scene begins, against small-on-large theory: how their tops give way to a small
load in 2D, around an axis and in 3D; u = 0 is at rest, energy is balanced, explicit steps feed nothing, a run that was
stopped goes on to the bit; what `check` says and refuses.
usage: prestretch.py SOFTWET"""

import pathlib
import subprocess

import numpy
import scipy.optimize
import scipy.special
from _same import check_same
from _scene import check, check_true, environment, history, open_output, record, run_file, softwet
from numpy.polynomial import legendre

YOUNG, POISSON, HEIGHT, ROWS, WIDTH = 0.7554, 0.45, 0.125, 8, 0.2
LAMBDA, SHEAR = YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON)), YOUNG / (2 * (1 + POISSON))
NEO, SVK = "neo_hookean", "saint_venant_kirchhoff"


def first_piola(law, f):
    """Of the unstretched material, for F of shape (3, 3)."""
    if law == SVK:
        e = 0.5 * (f.T @ f - numpy.eye(3))
        return f @ (LAMBDA * numpy.trace(e) * numpy.eye(3) + 2 * SHEAR * e)
    inverse = numpy.linalg.inv(f).T
    return SHEAR * (f - inverse) + LAMBDA * numpy.log(numpy.linalg.det(f)) * inverse


def moduli(law, along, across=1.0):
    """dP/dF at F = 1 of a layer that was stretched, in the plane of x and the height, and its stretch upright."""
    upright = scipy.optimize.brentq(lambda s: first_piola(law, numpy.diag([along, s, across]))[1, 1], 0.2, 3, xtol=1e-14)
    before = numpy.diag([along, upright, across])
    a = numpy.zeros((2, 2, 2, 2))
    for k in range(2):
        for m in range(2):
            step = numpy.zeros((3, 3))
            step[k, m] = 1e-6
            p = [first_piola(law, (numpy.eye(3) + s * step) @ before) @ before / numpy.linalg.det(before) for s in (1, -1)]
            a[:, :, k, m] = (p[0] - p[1])[:2, :2] / 2e-6
    return a, upright


def answer(k, a, n=30):
    """Displacement of the top (u_x sin kx, u_y cos kx) on a slip base for a force per volume of 1 in the top row of
    elements, one column for each component: polynomials in the height."""
    def basis(low, high):
        s, w = legendre.leggauss(n + 4)
        y = 0.5 * (low + high + (high - low) * s)
        return y, 0.5 * (high - low) * w, legendre.legvander(2 * y / HEIGHT - 1, n)
    y, w, v = basis(0, HEIGHT)
    slope = numpy.array([legendre.legval(2 * y / HEIGHT - 1, legendre.legder(e)) for e in numpy.eye(n + 1)]).T * 2 / HEIGHT
    parts = {(0, 0): (k * v, 0), (0, 1): (slope, 1), (1, 0): (-k * v, 1), (1, 1): (slope, 0)}  # of du_i/dx_j, even or odd
    size = n + 1
    matrix = numpy.zeros((2 * size, 2 * size))
    for (i, j), (one, odd) in parts.items():
        for (p, q), (other, also) in parts.items():
            if odd == also:
                matrix[i * size:(i + 1) * size, p * size:(p + 1) * size] += a[i, j, p, q] * (one.T * w) @ other
    bottom = legendre.legvander(numpy.array([-1.0]), n)[0]
    matrix[size:, size:] += 1e6 * abs(matrix).max() * numpy.outer(bottom, bottom)
    _, w_row, v_row = basis(HEIGHT * (1 - 1 / ROWS), HEIGHT)
    force = numpy.zeros((2 * size, 2))
    force[:size, 0] = force[size:, 1] = w_row @ v_row
    u = numpy.linalg.solve(matrix, force)
    return numpy.array([u[:size].sum(axis=0), u[size:].sum(axis=0)])


def write(name, size, elements, force, more="", time="end = 1"):
    box = [[0.0] * len(size), [WIDTH, *size[1:-1], HEIGHT]]
    box[0][-1] = HEIGHT * (1 - 1 / ROWS)
    pathlib.Path(f"{name}.toml").write_text(f"""
name = "{name}"
domain = {{ size = {size}, elements = {elements} }}
substrate = {{ thickness = {HEIGHT}, young = {YOUNG}, poisson = {POISSON}, material = "{NEO}" }}
{f'load = [{{ box = {box}, force = {force} }}]' if force else ''}
boundary = {{ bottom = "slip", top = "free" }}
time = {{ {time} }}
solver = {{ newton = {{ rtol = 1e-10, atol = 1e-15 }}, krylov = {{ rtol = 1e-4 }} }}
{more}
""")
    return f"{name}.toml"


def call(words, code=0):
    done = subprocess.run([softwet, *words], capture_output=True, text=True, timeout=900, env=environment)
    check_true(f"{' '.join(words[:1] + words[2:])}: exit code {code}", done.returncode == code, done.stdout + done.stderr)
    return done.stdout + done.stderr


def top_at_rest(case, folder, settings):
    """Reference places along x and displacement of the top of a layer that softwet steady brings to rest."""
    call(["steady", case, "--out", folder, "--overwrite", "--threads", "1", *(w for s in settings for w in ("--set", s))])
    run = open_output(folder)
    solid = run.fields(run.times[-1], "solid")
    return solid.reference[-1, ..., 0], solid["displacement"][-1]


def simpson(values, spacing):
    weights = numpy.ones(len(values))
    weights[1:-1:2], weights[2:-1:2] = 4, 2
    return values @ weights * spacing / 3


def compare(name, found, expected):
    check(f"{name}: largest error of the first waves of the top, over the largest of them", abs(found - expected).max() / abs(expected).max(),
          1e-4)


SMALL = 1e-4  # force per volume; displacements are about 1e-6
MODES = numpy.arange(1, 7)


def small_on_large():
    flat = write("flat", [1.0, HEIGHT], [64, ROWS], [SMALL, -2 * SMALL])
    round_ = write("round", [1.0, HEIGHT], [64, ROWS], [0.0, SMALL])
    deep = write("deep", [1.0, 0.125, HEIGHT], [32, 4, ROWS], [SMALL, 0.0, -2 * SMALL])
    k = numpy.pi * MODES
    loads = numpy.array([2 * SMALL * (1 - numpy.cos(WIDTH * k)) / k, -4 * SMALL * numpy.sin(WIDTH * k) / k])

    def in_plane(name, case, law, stretches):
        x, u = top_at_rest(case, name, [f"substrate.prestretch={list(stretches)}", f'substrate.material="{law}"'])
        if u.ndim == 3:
            check(f"{name}: the same at any depth", numpy.ptp(u, axis=0).max(), 1e-12)
            x, u = x[0], u[0][:, [0, 2]]
        found = numpy.array([[2 * simpson(u[:, 0] * numpy.sin(q * x), x[1]), 2 * simpson(u[:, 1] * numpy.cos(q * x), x[1])] for q in k])
        a = moduli(law, *stretches)[0]
        compare(name, found, numpy.array([answer(q, a) @ f for q, f in zip(k, loads.T)]))

    for law, stretch in ((NEO, 0.8), (NEO, 1.0), (NEO, 1.3), (SVK, 0.9), (SVK, 1.15)):
        in_plane(f"{law}_{stretch}", flat, law, [stretch])
    # Around the axis a layer is stretched alike along r and around it; its waves are J_0(k r) with J_1(k) = 0.
    x, u = top_at_rest(round_, "round", ["domain.coordinates=axisymmetric", "substrate.prestretch=[1.2]"])
    q = scipy.special.jn_zeros(1, len(MODES))
    norm = scipy.special.j0(q)**2 / 2
    found = numpy.array([simpson(u[:, 1] * scipy.special.j0(z * x) * x, x[1]) for z in q]) / norm
    a = moduli(NEO, 1.2, 1.2)[0]
    compare("round", found, numpy.array([answer(z, a)[1, 1] * SMALL * WIDTH * scipy.special.j1(z * WIDTH) / z for z in q]) / norm)
    in_plane("deep", deep, NEO, [1.25, 0.9])


def rest_and_motion():
    still = write("still", [1.0, HEIGHT], [32, ROWS], None)
    around, fibres = ["domain.coordinates=axisymmetric"], ["substrate.fibre.stiffness=0.5"]
    for name, words in (("still", []), ("still_round", around), ("still_fibres", fibres)):
        run_file(still, name, ["substrate.prestretch=[1.3]", *words])
        rows = history(name)
        check(f"{name}: kinetic energy of the layer that is stretched by 1.3", rows["energy_kinetic"].max(), 1e-28)
        check(f"{name}: its elastic energy over the energy of the stretched state", abs(rows["energy_elastic"]).max(), 1e-15)

    # The work of a strong load is in the energy; what is missing falls with the square of the step.
    push = write("push", [1.0, HEIGHT], [32, ROWS], [0.8, -1.0], time="end = 1, rho_inf = 1.0, tolerance = 1e30")
    missing = []
    for step in (0.02, 0.01):
        run_file(push, "push", ["substrate.prestretch=[1.3]", "load[0].ramp=0.5", f"time.dt_initial={step}", f"time.dt_max={step}"])
        rows = history("push")
        work = (0.5 * (rows["power_load"][1:] + rows["power_load"][:-1]) * numpy.diff(rows["t"])).sum()
        missing.append(abs(rows["energy_total"][-1] - rows["energy_total"][0] - work) / work)
    check("push: work that is not in the energy, relative", missing[1], 1e-3)
    check("push: the same over that with twice the step", missing[1] / missing[0], 0.3)
    run_file(push, "parts", ["substrate.prestretch=[1.3]", "time.dt_max=0.02", "time.max_steps=7"])
    run_file(push, "whole", ["substrate.prestretch=[1.3]", "time.dt_max=0.02", "time.max_steps=15"])
    run_file(push, "parts", ["substrate.prestretch=[1.3]", "time.dt_max=0.02", "time.max_steps=15"], ("--resume", "--quiet", "--threads", "1"))
    check_same("a resumed run", "parts", "whole")

    wave = write("wave", [1.0, HEIGHT], [48, ROWS], None, time="end = 20, max_steps = 3000",
                 more=f"""initial = {{ displacement = ["0.002*sin(4*pi*x/Lx)*y/{HEIGHT}", "0.0016*cos(9*pi*x/Lx)*y/{HEIGHT}"] }}
output = {{ fields = {{ times = [] }}, history = {{ every = 1 }} }}""")
    for stretch in (0.7, 1.5):
        for coordinates in ("plane", "axisymmetric"):
            name = f"wave_{stretch}_{coordinates}"
            run_file(wave, name, ["time.scheme=kick_drift", f"substrate.prestretch=[{stretch}]", f"domain.coordinates={coordinates}"])
            energy = history(name)["energy_total"]
            check(f"{name}: largest energy over the first, {record(name)['counts']['steps']} steps", energy.max() / energy[0], 1.05)


def words():
    case = write("words", [1.0, HEIGHT], [32, ROWS], None)

    def said(*settings, code=0):
        return call(["check", case, *(w for s in settings for w in ("--set", s))], code)

    told = said("substrate.prestretch=[1.2]")
    check_true("check: the stretches, the height before and the stress", all(part in told for part in (
        "1.2 along x, 0.85811 upright", "stretched solid", "0.14567 L0", "0.178 a b^2 (0.6833 G)")), told)
    svk = 'substrate.material="saint_venant_kirchhoff"'
    told = said("substrate.prestretch=[1.15]", svk)
    check_true("check: another law is recommended", 'write substrate.material = "neo_hookean"' in told, told)
    for settings, parts in (
            (["substrate.prestretch=[1.2]", svk], ["substrate.prestretch", "1.2", "0.85 and 1.15", "neo_hookean"]),
            (["substrate.prestretch=[0.8]", svk], ["substrate.prestretch", "0.8", "0.85 and 1.15"]),
            (["substrate.prestretch=[1.1, 1.1]"], ["substrate.prestretch", "1 number, not 2", "plane"]),
            (["substrate.prestretch=[0.3]"], ["substrate.prestretch", "[0.4, 3]"]),
            (["substrate.prestretch=[1.1]", svk, 'substrate.strain="small"'], ["substrate.prestretch", 'strain = "finite"']),
            (["substrate.prestretch=[1.1]", 'boundary.right="free"'], ["substrate.prestretch", "boundary.right is free", "slip"]),
            (["substrate.prestretch=[1.1]", "substrate.fibre.stiffness=1", "substrate.fibre.angle=30"], ["fibre.angle = 0"]),
            (["substrate.prestretch=[1.1]", "substrate.fibre.stiffness=1", "domain.coordinates=axisymmetric"], ["fibres", "(r, z)"])):
        told = said(*settings, code=1)
        check_true(f"{settings}: refused", all(part in told for part in parts), told)


words()
rest_and_motion()
small_on_large()
