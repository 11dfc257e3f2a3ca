#!/usr/bin/env python3
"""Scenes with an axis of symmetry: a free ball against the exact radial solution, a cap against its geometry, mass and
energies on a moving mesh, the same scene in 3D on its way and at rest, and what is refused.
usage: axisymmetric.py SOFTWET"""

import os
import pathlib
import sys

import numpy
from _scene import check, check_true, history, run, run_file
from softwet import open as open_output

sys.path.insert(0, str(pathlib.Path(os.environ["SOFTWET_SOURCE_DIR"]) / "tests" / "oracle"))
import radial_droplet  # noqa: E402

AXIAL = "domain.coordinates=axisymmetric"
REST = ["time.start=equilibrium", "time.end=1", "output.fields.times=[1]"]


def free_ball():
    """A ball in a cylinder with as much room as a ball of radius 0.5."""
    size, g = (0.5, 2 / 3), 1 / 24
    run("free_droplet_2d", "ball", [AXIAL, f"domain.size=[{size[0]},{size[1]}]", "domain.elements=[36,48]", f"fluid.capillarity={g}",
                                    f"droplet[0].centre=[0,{size[1] / 2}]", "droplet[0].radius=0.2", *REST])
    rows = history("ball")
    inside, outside, mu, radius = radial_droplet.solve(g, rows["mass"][-1], dimension=3, volume=numpy.pi * size[0]**2 * size[1])
    vapour, _ = radial_droplet.coexistence(0.39)
    check("ball: density inside", abs(rows["rho_max"][-1] / inside - 1), 3e-4)
    check("ball: density outside", abs(rows["rho_min"][-1] / outside - 1), 5e-3)
    check("ball: potential", abs(rows["laplace"][-1] / (mu - radial_droplet.energy_slope(0.39, vapour)) - 1), 3e-3)
    check("ball: largest speed at rest", rows["speed_max_fluid"][-1], 1e-5)
    check_true("ball: it is no disc", abs(inside - radial_droplet.solve(g, radial_droplet.sharp_mass(0.2))[0]) > 2e-3)


def cap_on_rigid_wall():
    """Contact radius, angle and potential of a cap of known volume."""
    g, angle, radius = 1 / 32, numpy.radians(75), 0.3
    run("static_droplet_rigid_2d", "cap", [AXIAL, "domain.size=[0.5,0.5]", "domain.elements=[32,32]", f"fluid.capillarity={g}",
                                           "droplet[0].centre=[0,0]", f"droplet[0].radius={radius}", *REST])
    rows = history("cap")
    check("cap: contact radius at the start", abs(rows["x_right"][0] - radius * numpy.sin(angle)), 0.3 * g)
    volume = numpy.pi * radius**3 * (2 + numpy.cos(angle)) * (1 - numpy.cos(angle))**2 / 3
    check("cap: volume from its mass", abs(rows["mass"][0] / (volume * rows["rho_max"][0]) - 1), 0.05)
    check("cap: angle at rest", abs(rows["angle_right"][-1] - 75), 3)
    check("cap: both sides alike", abs(rows["x_left"][-1] + rows["x_right"][-1]) + abs(rows["x_centre"][-1])
          + abs(rows["angle_left"][-1] - rows["angle_right"][-1]), 0)
    sigma, jump = 0.2532027493 * g, 0.8666990997 - 0.001352289801
    at_rest = rows["x_right"][-1] / numpy.sin(numpy.radians(rows["angle_right"][-1]))
    check("cap: potential by the law of Laplace", abs(rows["laplace"][-1] * jump * at_rest / (2 * sigma) - 1), 0.05)
    check("cap: mass", numpy.abs(rows["mass_drift"]).max(), 1e-13)


def layer():
    """Mass and energies on a moving mesh."""
    run("sessile_soft_axisymmetric", "layer", ["domain.elements=[24,24]", "fluid.capillarity=1/24", "droplet[0].radius=0.2",
                                               "substrate.young=5", "fluid.traction=blended", "time.end=1.2", "time.tolerance=1e-4",
                                               "output.fields.times=[1.2]", "solver.newton.rtol=1e-9", "solver.newton.atol=1e-14"])
    rows = history("layer")
    check_true("layer: the wall moves", open_output("layer").interface[1.2]["displacement_y"].max() > 5e-4)
    check("layer: mass on the moving mesh", numpy.abs(rows["mass_drift"]).max(), 1e-13)
    rate = rows["power_load"] + rows["wall_stretch"] - rows["dissipation"]
    gained = numpy.diff(rows["energy_total"]) - 0.5 * (rate[1:] + rate[:-1]) * numpy.diff(rows["t"])
    late = rows["t"][:-1] > 0.5  # the first steps from a sharp cap are left out
    lost = (rows["dissipation"][1:] * numpy.diff(rows["t"]))[late].sum()
    check("layer: open part of the balance of energy, of what is lost", numpy.abs(gained[late]).sum() / lost, 0.05)


SPACE = """
name = "{name}"
[domain]
{domain}
[fluid]
viscosity = 0.05
capillarity = 0.08
temperature = 0.39
contact_angle = 75.0
wall_law = "energy"
[substrate]
thickness = 0.1
young = 2.0
poisson = 0.45
[[droplet]]
centre = {centre}
radius = 0.24
[solver]
krylov = {{ preconditioner = "lu" }}
[time]
end = 2.0
[output]
fields = {{ times = [2.0] }}
"""


def against_space():
    """A droplet on a soft layer, and a quarter of it in a box whose base has a quarter of the area; on coarse
    meshes."""
    side = 0.4
    radius = 2 * side / numpy.sqrt(numpy.pi)
    for name, domain, centre in (("axial", f'coordinates = "axisymmetric"\nsize = [{float(radius)!r}, 0.4]\nelements = [9, 8]', [0, 0.1]),
                                 ("space", f"size = [{side}, {side}, 0.4]\nelements = [8, 8, 8]", [0, 0, 0.1])):
        pathlib.Path(f"{name}.toml").write_text(SPACE.format(name=name, domain=domain, centre=centre))
        run_file(f"{name}.toml", name)
        run_file(f"{name}.toml", f"{name}_at_rest", REST)
    axial, space = history("axial"), history("space")
    of_area = numpy.interp(axial["t"], space["t"], numpy.sqrt(4 * space["contact_area"] / numpy.pi))
    check("space: contact radius on the whole path", numpy.abs(axial["x_right"] / of_area - 1).max(), 0.01)
    check("space: mass against four quarters", abs(axial["mass"][0] / (4 * space["mass"][0]) - 1), 0.02)
    check("space: energy", abs(axial["energy_total"][-1] / (4 * space["energy_total"][-1]) - 1), 0.02)
    axial, space = (open_output(f"{name}_at_rest").interface[1.0]["displacement_" + up] for name, up in (("axial", "y"), ("space", "z")))
    check("space: ridge at rest", abs(axial.max() / space.max() - 1), 0.01)
    check("space: lowest point at rest", abs(axial.min() / space.min() - 1), 0.01)


def explicit_impact():
    """A ball that falls onto a wall, by explicit and by implicit steps."""
    words = ["domain.elements=[36,36]", "fluid.capillarity=1/27", "time.end=1", "output.fields.times=[1]", "output.history.every=1"]
    run("impact_axisymmetric", "implicit", [*words, "time.scheme=generalized_alpha", "time.tolerance=1e-4", "domain.quadrature=reduced"])
    run("impact_axisymmetric", "explicit", [*words, "time.scheme=kick_drift"])
    implicit, explicit = history("implicit"), history("explicit")
    check_true("impact: the wall was met", implicit["x_right"][-1] > 0.1, implicit["x_right"][-1])
    check("impact: contact radius", abs(explicit["x_right"][-1] / implicit["x_right"][-1] - 1), 0.01)
    fallen = implicit["energy_total"][0] - implicit["energy_total"][-1]
    check("impact: energy lost", abs((explicit["energy_total"][0] - explicit["energy_total"][-1]) / fallen - 1), 0.03)
    check("impact: mass", numpy.abs(explicit["mass_drift"]).max(), 1e-13)
    check("impact: the energy falls in every step", numpy.diff(explicit["energy_total"]).max(), 0)


def refusals():
    rigid, soft = "static_droplet_rigid_2d", "static_droplet_soft_2d"
    for case, settings, words in (
            (rigid, [], "droplet[0].centre"),
            (rigid, ["droplet[0].centre=[0,0]", "boundary.left=no_slip"], "boundary.left"),
            (rigid, ["droplet[0].centre=[0,0]", "fluid.gravity=[0.1,0]"], "fluid.gravity"),
            (rigid, ["droplet[0].centre=[0,0]", "droplet[0].velocity=[0.1,0]"], "droplet[0].velocity"),
            (soft, ["droplet[0].centre=[0,0.125]", "substrate.gravity=[0.1,0]"], "substrate.gravity"),
            ("tensotaxis_pull_2d", ["droplet[0].centre=[0,0.125]"], "load[0].force"),
            ("static_droplet_rigid_3d", [], "domain.coordinates")):
        said = run(case, "refused", [AXIAL, *settings], code=1)
        check_true(f"refused with a remedy: {words}", words in said and ("axisymmetric" in said or "2D only" in said), said.strip())


free_ball()
cap_on_rigid_wall()
layer()
against_space()
explicit_impact()
refusals()
