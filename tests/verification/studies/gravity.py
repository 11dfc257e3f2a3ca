"""Gravity: a column of liquid under its vapour at rest, and the balance of energy while it settles.

At rest the chemical potential and the potential of the force add up to a constant, mu - f . x = C, and the density obeys
W'(rho) - g^2 rho'' + f y = C with rho' = 0 at both ends and the mass of the run (f: force per unit mass, downwards).
scipy.integrate.solve_bvp solves this equation with the van der Waals law of tests/oracle/radial_droplet.py, without any
code of softwet. The pull of gravity is strong enough that the density of each phase changes along the column. Energy:
on a fixed mesh the total energy, gravity included, changes as - dissipation, up to the error of the time scheme,
which falls with the square of the step, and of the convective form of the inertia."""

import _measure
import numpy
from _case import case, fields, sides
from plane_interface import PlaneInterface
from radial_droplet import energy_curvature, energy_slope
from scipy.integrate import solve_bvp

MINUTES = {"quick": 0.2, "full": 0.6}
EXPLICIT = "a state at rest, which no scheme changes; to come to rest takes thousands of units of time"
THETA, CAPILLARITY, FORCE = 0.85, 1 / 16, 0.1
CASE = case("A column of liquid under its vapour, in gravity.", "column_in_gravity",
            domain=dict(size=[0.125, 1.0], elements=[8, 64]),
            fluid=dict(viscosity="1/16", capillarity=CAPILLARITY, temperature=THETA, gravity=[0.0, -FORCE]),
            film=[dict(box=[[0.0, 0.0], [1.0, 0.5]])],
            boundary=sides("slip"),
            time=dict(end=2000.0),
            output=fields(2000.0),
            solver=dict(newton=dict(rtol=1e-8, atol=1e-13)))


def exact(mass):
    """Density and C of the column at rest; unknowns rho, rho', the mass below y, and the parameter C."""
    plane = PlaneInterface(THETA)
    y = numpy.linspace(0, 1, 401)
    rho = plane.vapour + plane.step * 0.5 * (1 - numpy.tanh((y - 0.5) / (2 * CAPILLARITY)))
    start = numpy.stack([rho, numpy.gradient(rho, y), numpy.cumsum(rho) * (y[1] - y[0])])

    def slope(y, u, p):
        return numpy.stack([u[1], (energy_slope(THETA, u[0]) + FORCE * y - p[0]) / CAPILLARITY**2, u[0]])

    def ends(low, high, p):
        return numpy.array([low[1], high[1], low[2], high[2] - mass])

    found = solve_bvp(slope, ends, y, start, p=[plane.potential + FORCE / 2], tol=1e-10, max_nodes=100000)
    if not found.success:
        raise ValueError(found.message)
    return (lambda at: found.sol(at)[0]), found.p[0]


def rest(lab, n):
    run = lab.run(f"at rest, {n} elements", CASE, [f"domain.elements=[8,{n}]"])
    points, density = _measure.fluid_field(run.folder, 0)
    potential = _measure.fluid_field(run.folder, 0, "chemical_potential")[1]
    y = points[:, 0, 1]
    column, constant = exact(run.history["mass"][-1] / 0.125)
    level = potential + FORCE * points[:, :, 1]
    return {"density": numpy.abs(density - column(y)[:, None]).max(), "constant": numpy.abs(level - constant).max(),
            "speed": run.history["speed_max_fluid"][-1], "bottom": density[0, 0], "top": density[-1, 0]}


def study(lab):
    plane = PlaneInterface(THETA)
    meshes = (32, 64) if lab.quick else (32, 64, 128)
    found = {n: rest(lab, n) for n in meshes}
    lab.text(f"theta = {THETA}, gamma-hat = {CAPILLARITY}, f = {FORCE}. Largest errors at the points of the field file.")
    lab.table(("elements", "density", "mu + f y", "speed", "density at the bottom", "at the top"),
              [(n, f"{e['density']:.2e}", f"{e['constant']:.2e}", f"{e['speed']:.1e}", f"{e['bottom']:.6f}", f"{e['top']:.6f}")
               for n, e in found.items()], "rest")
    last = found[meshes[-1]]
    squeezed = FORCE * 0.5 / energy_curvature(THETA, plane.liquid)
    lab.expect("gravity squeezes the liquid: density at the bottom above the density of the flat interface",
               f">= {0.3 * squeezed:.3g}", f"{last['bottom'] - plane.liquid:.3g}", last["bottom"] - plane.liquid >= 0.3 * squeezed)
    lab.expect(f"density, {meshes[-1]} elements", "<= 1e-4", f"{last['density']:.1e}", last["density"] <= 1e-4)
    lab.expect(f"mu + f y, {meshes[-1]} elements", "<= 1e-5", f"{last['constant']:.1e}", last["constant"] <= 1e-5)
    rate = numpy.log2(found[meshes[-2]]["density"] / last["density"])
    lab.expect("order of the error of the density", ">= 2.5", f"{rate:.1f}", rate >= 2.5)
    balance(lab)


def balance(lab):
    steps = (0.02, 0.01) if lab.quick else (0.02, 0.01, 0.005)
    parts = []
    for dt in steps:
        run = lab.run(f"settling, dt = {dt}", CASE, ["domain.elements=[8,32]", "time.end=4", "output.fields.times=[4]",
                                                     "time.tolerance=1e3", f"time.dt_initial={dt}", f"time.dt_max={dt}"])
        parts.append(_measure.balance_error(run.folder, 0, 4))
        change = run.history["energy_gravity"][-1] - run.history["energy_gravity"][0]
    lab.table(("dt", "open in the balance, as a part of the dissipation"), [(dt, f"{p:.2e}") for dt, p in zip(steps, parts)], "balance")
    lab.expect("the energy of gravity takes part", "changes by > 1e-5", f"{change:.2g}", abs(change) > 1e-5)
    lab.expect(f"open at dt = {steps[-1]}", "<= 0.01", f"{parts[-1]:.1e}", parts[-1] <= 0.01)
