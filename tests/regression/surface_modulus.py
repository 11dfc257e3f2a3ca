#!/usr/bin/env python3
"""substrate.surface_modulus: layers at rest against linear theory, in 2D, around an axis and below a droplet; nothing
feeds the energy of an explicit run, which goes on from a checkpoint. usage: surface_modulus.py SOFTWET"""

import pathlib

import numpy
import scipy.special
from _same import check_same
from _scene import check, check_true, history, open_output, run_file
from _strip import CLOSE, FORCE, HEIGHT, LENGTH, POISSON, SIGMA, STRIP, YOUNG, of_strip, projected, rest, strip_load, write_layer
from _strip import _layer
import surface_tension as study  # the study, whose folder _strip adds to the path

K = numpy.pi / LENGTH  # 4 pi: half a wave


def moduli(modulus, tension=0.0):
    """lambda_s + 2 G_s is the modulus."""
    return f"surface_modulus = [{0.4 * modulus}, {0.3 * modulus}], surface_tension = {tension}"


# --- linear theory itself: numbers of an independent program, splines of degree 2 on 64 x 8 elements
compliance = _layer.compliance(K, HEIGHT, YOUNG, POISSON, tension=5 * SIGMA, modulus=20 * SIGMA)
check("linear theory: u_x for t_x, off u_x of splines", abs(compliance[0, 0] / 0.051320 - 1), 3e-5)

# --- 2D, a tangential force of all odd waves and a vertical one of all: the first wave of each displacement
for modulus, tension, strain in ((0, 0, "finite"), (20, 5, "finite"), (200, 0, "small")):
    layer = {"modulus": modulus * SIGMA, "tension": tension * SIGMA}
    solid = f'{moduli(modulus * SIGMA, tension * SIGMA)}, strain = "{strain}"'
    exact = of_strip(K, **layer)
    along = rest(write_layer(f"along_{modulus}", solid, load=strip_load(LENGTH, [FORCE, 0.0])))
    down = rest(write_layer(f"down_{modulus}", solid, load=strip_load(LENGTH / 2, [0.0, FORCE])))
    sine, cosine = (lambda x: numpy.sin(K * x)), (lambda x: numpy.cos(K * x))
    for run, axis, wave, column, row, of_force in (
            (along, "x", sine, 0, 0, 2 / K), (along, "y", cosine, 0, 1, 2 / K),
            (down, "x", sine, 1, 0, 1 / K), (down, "y", cosine, 1, 1, 1 / K)):
        found = projected(run, axis, wave) / (FORCE * STRIP * of_force)
        check(f"M = {modulus} sigma, {strain} strain: u_{axis} for t_{'xy'[column]} is {found:.6f}, theory {exact[row, column]:.6f}, off",
              abs(found - exact[row, column]) / (exact[row, row] * exact[column, column])**0.5, CLOSE)
    energies = along.history
    check_true(f"M = {modulus} sigma: its energy", (energies["energy_surface"][-1] > 0) == (modulus > 0))

# --- around an axis: a vertical force on a disc, and the first waves, J_0 of the vertical displacement and J_1 of the
# radial one
zero = scipy.special.jn_zeros(1, 1)[0]
k, disc = zero / LENGTH, LENGTH / 2
for modulus in (0, 200):
    run = rest(write_layer(f"around_{modulus}", moduli(modulus * SIGMA), load=strip_load(disc, [0.0, FORCE]),
                           coordinates="axisymmetric"))
    exact = of_strip(k, modulus=modulus * SIGMA)
    for name, axis, wave, row in (("u_r", "x", scipy.special.j1, 0), ("u_z", "y", scipy.special.j0, 1)):
        found = projected(run, axis, lambda r: wave(k * r), weight=lambda r: r) / (FORCE * STRIP * disc * scipy.special.j1(k * disc) / k)
        check(f"around an axis, M = {modulus} sigma: {name} for t_z is {found:.6f}, theory {exact[row, 1]:.6f}, off",
              abs(found - exact[row, 1]) / (exact[row, row] * exact[1, 1])**0.5, CLOSE)

# --- below a droplet: numbers of an independent program, and a layer and a face so stiff that slopes are small, as in
# the study; its
# tolerance is 3 %
line, fine = study.FIG2.radius * numpy.sin(numpy.radians(study.FIG2.angle)), numpy.linspace(0, study.FIG2.length, 1001)
for modulus, ridge, at_line in ((0, 4.3085e-3, 1.947e-3), (1, 4.2973e-3, 1.531e-3), (3, 4.2851e-3, 1.167e-3), (10, 4.2622e-3, 0.717e-3)):
    u = study.linear_theory(fine, study.FIG2, YOUNG, SIGMA, False, modulus * SIGMA)
    check(f"linear theory below a droplet, M = {modulus} sigma: the ridge, off", abs(u[1].max() / ridge - 1), 1e-4)
    check(f"linear theory below a droplet, M = {modulus} sigma: |u_x| at the line, off", abs(-numpy.interp(line, fine, u[0]) / at_line - 1), 1e-3)
STIFF, at_lines = study.FACTOR, {}
for modulus in (0, 10):
    face = {"surface_tension": STIFF * SIGMA, "surface_modulus": [0.4 * STIFF * modulus * SIGMA, 0.3 * STIFF * modulus * SIGMA]}
    pathlib.Path("droplet.toml").write_text(study.half(study.FIG2, [64, 64], 0.5, STIFF * YOUNG, face, 300.0, wall_tension="none"))
    run_file("droplet.toml", f"droplet_{modulus}")
    walls = open_output(f"droplet_{modulus}").interface
    wall = walls[max(walls)]
    x, u = wall["x_reference"], [wall["displacement_x"], wall["displacement_y"]]
    theory = study.linear_theory(x, study.FIG2, STIFF * YOUNG, STIFF * SIGMA, False, STIFF * modulus * SIGMA)
    for row, axis in enumerate("xy"):
        check(f"below a droplet, M = {modulus} sigma: u_{axis}, off over the ridge",
              numpy.abs(u[row] - theory[row]).max() / theory[1].max(), 0.03)
    at_lines[modulus] = numpy.interp(line, x, u[0]) / numpy.interp(line, x, theory[0])
check("below a droplet: what M = 10 sigma makes of u_x at the line, off", abs(at_lines[10] / at_lines[0] - 1), 0.03)

# --- an explicit run whose face takes and gives a part of the energy: its swing falls with the square of the step
WAVES = '[initial]\ndisplacement = ["0.004*sin(2*pi*x/Lx)*y/H", "0.003*cos(2*pi*2*x/Lx)*y/H"]\n'
swings = {}
for name, safety in (("whole", 0.8), ("half", 0.4)):
    case = write_layer("swings", f"{moduli(0.05, 0.01)}, density = 1.0", more=WAVES, elements=(16, 8),
                       time=f'time = {{ end = 1.0, scheme = "kick_drift", mass = "consistent", safety = {safety} }}')
    run_file(case, name)
    rows = history(name)
    energy, face = rows["energy_total"], rows["energy_surface"]
    swings[name] = energy.max() / energy.min() - 1
    check_true(f"{name}: energy that the face takes and gives, of the whole", (face.max() - face.min()) > 0.1 * energy[0],
               f"{(face.max() - face.min()) / energy[0]:.2f}")
check("largest energy over the smallest, less 1", swings["whole"], 0.02)
check("the same with half the step, over that: second order", swings["half"] / swings["whole"], 0.3)

run_file(case, "parts", ["time.max_steps=100"])
run_file(case, "parts", options=("--resume", "--quiet", "--threads", "1"))
check_same("a resumed run", "parts", "half")
