"""Plane interface: densities, potential, width and surface tension at five temperatures.

A film in a quasi one-dimensional channel between slip sides comes to rest. Exact answers:
tests/oracle/plane_interface.py (equal pressure and chemical potential in both phases; first integral g^2 rho'^2/2 =
D(rho) of the profile). The table it gives is compared with the digits of the 40-digit oracle
tests/oracle/equilibrium.py. The tension of the run is the excess of the energy per area: int (W + g^2 rho'^2/2 - mu_sat
rho + p_sat) dx = E - mu_sat M + p_sat L, with energy_free E and mass M of history.csv over the height of the channel
and its length L; deviations of the bulk densities enter it in second order. The viscosity is small because the vapour
settles through the interface, in a time that grows with it."""

import _measure
import _shape
import numpy
from _case import case, fields
from plane_interface import PlaneInterface

MINUTES = {"quick": 0.1, "full": 0.4}
CASE = case("A liquid film on the left side, vapour on the right: one plane interface.", "plane_interface",
            domain=dict(size=[1.0, 0.0625], elements=[128, 4]),
            fluid=dict(viscosity="1/1024", capillarity="1/64", temperature=0.39),
            film=[dict(box=[[0.0, 0.0], [0.5, 1.0]])],
            boundary=dict(top="slip"),
            time=dict(end=4000.0),
            output=fields(4000.0),
            solver=dict(newton=dict(rtol=1e-9, atol=1e-14)))
# theta: rho_v, rho_l, p_sat, mu_sat, c_l, c_v, sigma/g, 10-90 % width/g; all but the last by
# tests/oracle/equilibrium.py.
TABLE = {0.39: (0.001352289801, 0.8666990997, 1.546475127e-4, -0.6501910901, 2.183979206, 0.3363987816, 0.2532027493),
         0.5: (0.007248935716, 0.8194973335, 1.029210928e-3, -0.5941013404, 1.705299831, 0.3685399457, 0.1915416203),
         0.7: (0.04267410056, 0.7134808495, 7.424387670e-3, -0.5138467876, 1.048582202, 0.3754494221, 0.09240093455),
         0.85: (0.1065766548, 0.6023801091, 1.868487592e-2, -0.4667444110, 0.6230687974, 0.3199521076, 0.03356246858),
         0.95: (0.1930049756, 0.4872424479, 3.006960161e-2, -0.4398957867, 0.3100182300, 0.2149727617, 0.006570685483)}


def state(run, plane, g):
    """Measured values by name, with the exact ones."""
    points, density = _measure.fluid_field(run.folder, 0)
    x, rho = points[0, :, 0], density[density.shape[0] // 2]
    (height, length) = points[-1, 0, 1], x[-1]
    last = {name: values[-1] for name, values in run.history.items()}
    energy, mass = (last["energy_free"] + last["energy_kinetic"]) / height, last["mass"] / height
    levels = [_shape.position(x, rho, plane.vapour + part * plane.step) for part in (0.1, 0.9)]
    return {"rho_v": (rho[-1], plane.vapour), "rho_l": (rho[0], plane.liquid),
            "mu": (_measure.fluid_field(run.folder, 0, "chemical_potential")[1].mean(), plane.potential),
            "width/g": ((levels[0] - levels[1]) / g, plane.width),
            "sigma/g": ((energy - plane.potential * mass + plane.pressure * length) / g, plane.tension)}


def study(lab):
    planes = {theta: PlaneInterface(theta) for theta in TABLE}
    worst = max(abs(found / asked - 1) for theta, row in TABLE.items() for found, asked in zip(
        (lambda p: (p.vapour, p.liquid, p.pressure, p.potential, p.sound_speed(p.liquid), p.sound_speed(p.vapour),
                    p.tension))(planes[theta]), row))
    lab.expect("table of the two oracles", "the same, 1e-9", f"{worst:.1g}", worst <= 1e-9)
    thetas = (0.39, 0.85) if lab.quick else TABLE
    runs = lab.runs({f"theta = {theta}": (CASE, [f"fluid.temperature={theta}"]) for theta in thetas})
    rows = []
    for theta, run in zip(thetas, runs.values()):
        for name, (found, exact) in state(run, planes[theta], 1 / 64).items():
            error, bound = found / exact - 1, 0.002 if name == "width/g" else 0.001
            lab.expect(f"theta = {theta}: {name}", f"{exact:.8g} +- {100 * bound:g} %", f"{found:.8g}, {100 * error:+.3g} %",
                       abs(error) <= bound)
            rows.append((theta, name, exact, found, f"{error:+.1e}"))
    lab.table(("theta", "quantity", "exact", "run, gamma_hat = 2h", "relative error"), rows, "bulk")
    if not lab.quick:
        convergence(lab, planes)


def convergence(lab, planes):
    lab.title("Convergence with the mesh")
    meshes, thetas = (64, 128, 256, 512), (0.39, 0.85)
    runs = lab.runs({f"theta = {theta}, {n} elements": (CASE, [f"fluid.temperature={theta}", f"domain.elements=[{n},4]"])
                     for theta in thetas for n in meshes})
    rows, errors = [], {}
    for theta in thetas:
        for n in meshes:
            values = state(runs[f"theta = {theta}, {n} elements"], planes[theta], 1 / 64)
            errors[theta, n] = {name: abs(found / exact - 1) for name, (found, exact) in values.items()}
            rows.append((theta, f"{n / 64:g}", *(f"{found / exact - 1:+.1e}" for found, exact in values.values())))
    lab.table(("theta", "gamma_hat / h", *values), rows, "convergence")
    for theta in thetas:
        rate = numpy.log2(errors[theta, 64]["sigma/g"] / errors[theta, 256]["sigma/g"]) / 2
        lab.expect(f"theta = {theta}: order of the error of sigma, h = g to g/4", ">= 3 (the energy of quadratics: 4)",
                   f"{rate:.1f}", rate >= 3)


def explicit(lab):
    """Temperatures 0.7 and 0.85 on 128 x 4 elements, brought to rest by `time.start`; then explicit steps to t = 0.2,
    after which the same is asked."""
    for theta in (0.7, 0.85):
        plane = PlaneInterface(theta)
        run = lab.run(f"theta = {theta}", CASE, [f"fluid.temperature={theta}", "time.start=equilibrium", "time.end=0.2",
                                                 "output.fields.times=[0.2]"])
        for name, (found, exact) in state(run, plane, 1 / 64).items():
            error, bound = found / exact - 1, 0.002 if name == "width/g" else 0.001
            lab.expect(f"theta = {theta}: {name}", f"{exact:.6g} +- {100 * bound:g} %", f"{100 * error:+.3g} %", abs(error) <= bound)
