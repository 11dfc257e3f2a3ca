"""Large strains in closed form: stretched, compressed and sheared columns.

A column of Saint Venant-Kirchhoff of height H between slip sides, under gravity: only u_y(Y) differs from 0, and the
free top carries nothing, so P_22(Y) = rho f (H - Y) exactly. With F_22 = s, P_22 = (lambda + 2 G) s (s^2 - 1)/2: s is a
root of a cubic, u_y the integral of s - 1. Hanging (f > 0, from a slip bottom that holds u_y = 0) the root is the one
above 1; pressed (f < 0) it is the one in (1/sqrt(3), 1), where the material is stable.

A sheared column, periodic sides, bottom clamped, force along x: u_x(Y) and u_y(Y). With g = u_x' and s = 1 + u_y':
E_12 = g/2, E_22 = (g^2 + s^2 - 1)/2, S_12 = G g, S_22 = (lambda + 2 G) E_22, P_12 = S_12 + g S_22, P_22 = s S_22.
Balance asks for P_22 = 0 and P_12 = rho f (H - Y): S_22 = 0, g = rho f (H - Y)/G, s = sqrt(1 - g^2).

Rest is reached with rho_inf = 0. Error of u: root mean square over the ends and middles of the elements (where a
quadratic is one order better than elsewhere), order p + 1; the elastic energy, int (lambda/2 + G) E_22^2 + ..., has
order 2 p."""

import _measure
import numpy
import scipy.optimize
from _case import case, fields, sides

MINUTES = {"quick": 0.1, "full": 0.1}
EXPLICIT = ("the solid comes to rest by the damping of the implicit scheme (rho_inf = 0); explicit schemes leave its waves "
            "undamped, so it swings for ever")
CASE = case("A column of solid: every displacement depends on the height alone.", "column",
            domain=dict(size=[0.5, 1.0], elements=[7, 8]),
            substrate=dict(thickness=1.0, density=1.0, young=1.0, poisson=0.3),
            load=[dict(box=[[0.0, 0.0], [0.5, 1.0]], force=[0.0, 0.1], ramp=20.0)],
            boundary=sides("slip", top="free"),
            time=dict(rho_inf=0.0, tolerance=0.05, end=1000.0),
            solver=dict(newton=dict(rtol=1e-9, atol=1e-13), krylov=dict(rtol=1e-4)),
            output=fields(1000.0))
POISSON = 0.3
LAME, SHEAR = POISSON / ((1 + POISSON) * (1 - 2 * POISSON)), 0.5 / (1 + POISSON)
STIFFNESS = LAME + 2 * SHEAR
SCENES = {  # name: (settings, force)
    "hanging": ([], 1.2),
    "pressed": ([], -0.2),
    "sheared": (["boundary.left=periodic", "boundary.right=periodic", "boundary.bottom=clamped"], 0.27),
}


def strain(name, force, y):
    """(u_x', u_y') at the height y."""
    load = force * (1 - y)
    if name == "sheared":
        g = load / SHEAR
        return g, numpy.sqrt(1 - g**2) - 1
    low, high = (1, 3) if force > 0 else (3**-0.5, 1)
    s = scipy.optimize.brentq(lambda s: STIFFNESS * s * (s * s - 1) / 2 - load, low, high, xtol=1e-15) if load else 1.0
    return 0.0, s - 1


def exact(name, force, heights):
    """u_x, u_y at increasing heights, the first 0, and the elastic energy per width."""
    x, w = numpy.polynomial.legendre.leggauss(12)
    u, energy = [numpy.zeros(2)], 0.0
    for a, b in zip(heights, heights[1:]):
        g, s = numpy.array([strain(name, force, a + 0.5 * (b - a) * (t + 1)) for t in x]).T
        e = 0.5 * (g**2 + (1 + s)**2 - 1)
        u.append(u[-1] + 0.5 * (b - a) * numpy.array([w @ g, w @ s]))
        energy += 0.5 * (b - a) * w @ (0.5 * LAME * e**2 + SHEAR * (e**2 + 0.5 * g**2))
    return numpy.array(u), energy


def errors(run, name, force):
    """Root mean square error of u over the column as a part of the largest |u|, relative error of the energy, how far u
    differs along x."""
    place, u = _measure.solid_field(run.folder, 0)
    across = numpy.isclose(place[:, 1], 0).sum()
    grid, heights = u.reshape(-1, across, 2), place[::across, 1]
    true, energy = exact(name, force, heights)
    size = numpy.abs(true).max()
    return (numpy.sqrt(((grid[:, 0] - true)**2).sum(axis=1).mean()) / size,
            abs(run.history["energy_elastic"][-1] / (0.5 * energy) - 1), numpy.ptp(grid, axis=1).max() / size)


def study(lab):
    meshes = (8, 16) if lab.quick else (4, 8, 16, 32)
    wanted, labels = {}, {}
    for name, (settings, force) in SCENES.items():
        direction = f"[{force},0]" if name == "sheared" else f"[0,{force}]"
        for p in (2, 3):
            for n in meshes:
                labels[name, p, n] = f"{name}, degree {p}, {n} elements"
                wanted[labels[name, p, n]] = (CASE, [
                    *settings, f"load[0].force={direction}", f"domain.degree={p}", f"domain.elements=[7,{n}]"])
    runs = lab.runs(wanted)
    found = {key: errors(runs[label], key[0], SCENES[key[0]][1]) for key, label in labels.items()}
    rows = []
    for (name, p, n), e in found.items():
        order = [numpy.log2(a / b) for a, b in zip(found[name, p, n // 2], e)][:2] if (name, p, n // 2) in found else ("", "")
        rows.append((name, p, n, f"{e[0]:.2e}", order[0] and f"{order[0]:.2f}", f"{e[1]:.2e}", order[1] and f"{order[1]:.2f}"))
    for name, (_, force) in SCENES.items():
        g, s = strain(name, force, 0.0)
        lab.text(f"{name}: force {force:g}, at the bottom F_22 = {1 + s:.4f}, F_12 = {g:.4f}.")
    lab.table(("column", "degree", "elements", "error of u", "order", "error of the energy", "order"), rows, "columns")
    last = meshes[-1]
    for name in SCENES:
        for p in (2, 3):
            fine, coarse = found[name, p, last], found[name, p, last // 2]
            orders = [numpy.log2(a / b) for a, b in zip(coarse, fine)][:2]
            lab.expect(f"{name}, degree {p}: order of u", f">= {p + 0.5}", f"{orders[0]:.2f}, error {fine[0]:.1e}",
                       orders[0] >= p + 0.5)
            lab.expect(f"{name}, degree {p}: order of the energy", f">= {2 * p - 0.5}", f"{orders[1]:.2f}, error {fine[1]:.1e}",
                       orders[1] >= 2 * p - 0.5)
        across = max(found[name, p, last][2] for p in (2, 3))
        lab.expect(f"{name}: differs along x", "<= 1e-8", f"{across:.1e}", across <= 1e-8)
