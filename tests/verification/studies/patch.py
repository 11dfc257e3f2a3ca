"""Large strains in closed form: stretched, compressed and sheared columns, with fibres, and under their own weight.

A column of height H of which every displacement depends on the height alone. With g = u_x' and s = 1 + u_y' the deformation is
F = [[1, g], [0, s]], and the balance of forces asks for P_12(Y) = rho f_x (H - Y), P_22(Y) = rho f_y (H - Y), whatever the material,
because the free top carries nothing: two equations for g and s at each height, u is the integral of (g, s - 1).

Saint Venant-Kirchhoff, between slip sides (g = 0): P_22 = (lambda + 2 G) s (s^2 - 1)/2. Hanging (f_y > 0, from a slip bottom that holds
u_y = 0) the root is the one above 1; pressed it is the one in (1/sqrt(3), 1), where the material is stable. Between periodic sides over a
clamped bottom, force along x: P_22 = 0 gives S_22 = 0, g = rho f (H - Y)/G, s = sqrt(1 - g^2). These forces are a load
on all of the column, or substrate.gravity, whose energy is - rho int f.u.

Fibres along a_0 add k/2 (I_4 - 1)^2 to the energy, I_4 = |F a_0|^2, so that P gets 2 k (I_4 - 1) F a_0 a_0^T. Upright fibres stiffen a
column between slip sides; oblique ones shear a column under its weight between periodic sides.

Rest is reached with rho_inf = 0. Error of u: root mean square over the ends and middles of the elements (where a
quadratic is one order better than elsewhere), order p + 1; the elastic energy has order 2 p."""

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
PERIODIC = ["boundary.left=periodic", "boundary.right=periodic", "boundary.bottom=clamped"]
WEIGHT = ["load[0].force=[0,0]"]  # no load: the force is substrate.gravity
FIBRES = 0.4  # their stiffness
SCENES = {  # name: (settings, force, angle of the fibres in degrees or none, neo-Hookean)
    "hanging": ([], (0, 1.2), None, False),
    "pressed": ([], (0, -0.2), None, False),
    "sheared": (PERIODIC, (0.27, 0), None, False),
    "hanging by its weight": (WEIGHT, (0, 1.2), None, False),
    "hanging on fibres": (WEIGHT, (0, 1.2), 90, False),
    "pressed on oblique fibres": (PERIODIC, (0, -0.2), 30, False),
    "pressed neo-Hookean on oblique fibres": ([*WEIGHT, *PERIODIC], (0, -1.0), 120, True),
}


def energy_of(scene, f):
    """Energy per undeformed volume of the deformations F."""
    _, _, angle, neo = scene
    c = numpy.swapaxes(f, -1, -2) @ f
    trace = c[..., 0, 0] + c[..., 1, 1]
    if neo:
        log = numpy.log(numpy.linalg.det(f))
        energy = 0.5 * SHEAR * (trace - 2) - SHEAR * log + 0.5 * LAME * log**2
    else:
        e = 0.5 * (c - numpy.eye(2))
        energy = 0.5 * LAME * (0.5 * trace - 1)**2 + SHEAR * (e**2).sum(axis=(-1, -2))
    if angle is not None:
        a = numpy.array([numpy.cos(numpy.radians(angle)), numpy.sin(numpy.radians(angle))])
        energy = energy + 0.5 * FIBRES * (a @ c @ a - 1)**2
    return energy


def stress(scene, g, s):
    """(P_12, P_22), the slopes of the energy along g and s: exact differences, because the step is imaginary."""
    step = 1e-30j
    return [energy_of(scene, numpy.array([[1, a], [0, b]])).imag / 1e-30 for a, b in ((g + step, s + 0j), (g + 0j, s + step))]


def strain(name, y, start):
    """(u_x', u_y') at the height y, found from the slopes of a place nearby."""
    scene = SCENES[name]
    force = numpy.array(scene[1]) * (1 - y)
    if "boundary.left=periodic" not in scene[0]:
        low, high = (1, 3) if scene[1][1] > 0 else (3**-0.5, 1)
        s = scipy.optimize.brentq(lambda s: stress(scene, 0.0, s)[1] - force[1], low, high, xtol=1e-15) if y < 1 else 1.0
        return 0.0, s - 1
    found = scipy.optimize.root(lambda d: numpy.subtract(stress(scene, d[0], 1 + d[1]), force), start, tol=1e-13)
    if numpy.abs(found.fun).max() > 1e-10:
        raise ValueError(f"{name}: no strain at the height {y}")
    return tuple(found.x)


def exact(name, heights):
    """u_x, u_y at increasing heights, the first 0; per width the elastic energy and - int f.u."""
    x, w = numpy.polynomial.legendre.leggauss(12)
    strains, near = {}, (0.0, 0.0)
    for a, b in list(zip(heights, heights[1:]))[::-1]:  # from the top, which carries nothing
        strains[a] = []
        for t in x[::-1]:
            near = strain(name, a + 0.5 * (b - a) * (t + 1), near)
            strains[a].insert(0, near)
    u, energy, weight = [numpy.zeros(2)], 0.0, 0.0
    for a, b in zip(heights, heights[1:]):
        g, s = numpy.array(strains[a]).T
        slope = numpy.array([w @ g, w @ s]) * 0.5 * (b - a)
        # int f.u = int f.u' (H - y)
        weight -= 0.5 * (b - a) * w @ ((SCENES[name][1][0] * g + SCENES[name][1][1] * s) * (1 - a - 0.5 * (b - a) * (x + 1)))
        u.append(u[-1] + slope)
        f = numpy.zeros((len(x), 2, 2))
        f[:, 0, 0], f[:, 0, 1], f[:, 1, 1] = 1, g, 1 + s
        energy += 0.5 * (b - a) * w @ energy_of(SCENES[name], f)
    return numpy.array(u), energy, weight


def errors(run, name):
    """Root mean square error of u over the column as a part of the largest |u|, relative error of the elastic energy,
    how far u differs along x, relative error of the energy of the weight."""
    place, u = _measure.solid_field(run.folder, 0)
    across = numpy.isclose(place[:, 1], 0).sum()
    grid, heights = u.reshape(-1, across, 2), place[::across, 1]
    true, energy, weight = exact(name, heights)
    size = numpy.abs(true).max()
    return (numpy.sqrt(((grid[:, 0] - true)**2).sum(axis=1).mean()) / size,
            abs(run.history["energy_elastic"][-1] / (0.5 * energy) - 1), numpy.ptp(grid, axis=1).max() / size,
            abs(run.history["energy_gravity"][-1] / (0.5 * weight) - 1))


def in_space(lab):
    """A 3D column whose oblique fibres are turned about the vertical: the plane column, turned like them."""
    name, turn = "pressed on oblique fibres", numpy.radians(35)
    words = [word for word in settings(name) if not word.startswith("load")]
    run = lab.run(f"{name}, in 3D", CASE, [
        *words, "domain.size=[0.5,0.5,1]", "domain.elements=[5,5,8]", "load[0].box=[[0,0,0],[0.5,0.5,1]]", "load[0].force=[0,0,-0.2]",
        "boundary.front=periodic", "boundary.back=periodic", "substrate.fibre.azimuth=35"])
    wall = _measure.interface(run.folder)
    top = exact(name, numpy.linspace(0, 1, 9))[0][-1]
    wanted = numpy.array([top[0] * numpy.cos(turn), top[0] * numpy.sin(turn), top[1]])
    found = numpy.array([wall[f"displacement_{d}"] for d in "xyz"])
    error = numpy.abs(found - wanted[:, None]).max() / numpy.abs(top).max()
    lab.expect(f"{name}, in 3D, turned by 35 degrees: displacement of the top", "within 1e-4", f"{error:.1e}", error <= 1e-4)


def settings(name):
    words, force, angle, neo = SCENES[name]
    key = "substrate.gravity" if "load[0].force=[0,0]" in words else "load[0].force"
    fibres = [] if angle is None else [f"substrate.fibre.stiffness={FIBRES}", f"substrate.fibre.angle={angle}"]
    return [*words, f"{key}=[{force[0]},{force[1]}]", *fibres, *(["substrate.material=neo_hookean"] if neo else [])]


def study(lab):
    meshes = (8, 16) if lab.quick else (4, 8, 16, 32)
    wanted, labels = {}, {}
    for name in SCENES:
        for p in (2, 3):
            for n in meshes:
                labels[name, p, n] = f"{name}, degree {p}, {n} elements"
                wanted[labels[name, p, n]] = (CASE, [*settings(name), f"domain.degree={p}", f"domain.elements=[7,{n}]"])
    runs = lab.runs(wanted)
    found = {key: errors(runs[label], key[0]) for key, label in labels.items()}
    rows = []
    for (name, p, n), e in found.items():
        order = [numpy.log2(a / b) for a, b in zip(found[name, p, n // 2], e)][:2] if (name, p, n // 2) in found else ("", "")
        rows.append((name, p, n, f"{e[0]:.2e}", order[0] and f"{order[0]:.2f}", f"{e[1]:.2e}", order[1] and f"{order[1]:.2f}"))
    for name, (_, force, angle, _) in SCENES.items():
        heights = numpy.linspace(0, 1, 5)
        g, s = strain(name, 0.0, (exact(name, heights)[0][1] - exact(name, heights)[0][0]) / heights[1])
        fibres = "" if angle is None else f"fibres of stiffness {FIBRES} at {angle} degrees, "
        lab.text(f"{name}: {fibres}force {list(force)}, at the bottom F_22 = {1 + s:.4f}, F_12 = {g:.4f}.")
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
        if "load[0].force=[0,0]" in SCENES[name][0]:
            error = max(found[name, p, last][3] for p in (2, 3))
            lab.expect(f"{name}: energy of the weight", "within 1e-5", f"{error:.1e}", error <= 1e-5)
    in_space(lab)
