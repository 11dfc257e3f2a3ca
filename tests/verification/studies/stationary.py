"""Solid at rest under all that acts on it: the slope of its energy, written down once more, vanishes

A layer of solid alone with a strong surface tension, oblique fibres, gravity and a load that lifts a part of it is brought to rest in
large deformation. Its displacement is read from the field file, and turned back into the control values of the spline. The energy

    int psi(F) + k/2 (|F a_0|^2 - 1)^2  +  int_top U (a - 1)  -  int rho f.u,   a: area of the deformed top over the undeformed one,

is written here from these formulas, without code of softwet; its slopes come from the densities, along imaginary steps. The
integrals take the same Gauss points. At rest the slope along every control value that may move is 0. It is compared with the largest
slope of the weakest part: were that part wrong, as much would be left. energy_elastic, energy_surface and energy_gravity are compared
with the same integrals."""

import itertools

import _layer
import _measure
import numpy
import scipy.interpolate
from _case import case, fields

MINUTES = {"quick": 0.2, "full": 0.3}
EXPLICIT = ("the solid comes to rest by the damping of the implicit scheme (rho_inf = 0); explicit schemes leave its waves "
            "undamped, so it swings for ever")
YOUNG, POISSON, TENSION, FIBRES, ANGLE, AZIMUTH, WEIGHT, HEIGHT = 1.0, 0.4, 0.15, 0.3, 30.0, 50.0, -0.5, 0.25
FIRST, SHEAR = _layer.lame(YOUNG, POISSON)


def scene(dimension, material):
    along = dimension - 1
    elements = [16, 4] if dimension == 2 else [8, 8, 4]
    lift = [3.0, 8.0] if dimension == 2 else [2.0, 1.0, 8.0]
    fibre = dict(stiffness=FIBRES, angle=ANGLE, **(dict(azimuth=AZIMUTH) if dimension == 3 else {}))
    box = [[0.375] * along + [0.125], [0.625] * along + [HEIGHT]]
    return dict(elements=elements, box=box, lift=lift), case(
        "A layer at rest under its surface tension, fibres, weight and a load.", "layer_at_rest",
        domain=dict(size=[1.0] * along + [HEIGHT], elements=elements),
        substrate=dict(thickness=HEIGHT, young=YOUNG, poisson=POISSON, material=material, surface_tension=TENSION, fibre=fibre,
                       gravity=[0.0] * along + [WEIGHT]),
        load=[dict(box=box, force=lift, ramp=20.0)],
        boundary=dict(bottom="clamped", top="free"),
        time=dict(rho_inf=0.0, tolerance=0.05, end=1000.0),
        solver=dict(newton=dict(rtol=1e-9, atol=1e-13), krylov=dict(rtol=1e-4)),
        output=fields(1000.0))


class Axis:
    """C1 quadratic splines on n elements of a length, and their values at the three Gauss points of each element that
    softwet takes."""

    def __init__(self, length, n):
        self.breaks, self.n = numpy.linspace(0, length, n + 1), n
        self.knots = numpy.concatenate(([0, 0], self.breaks, [length, length]))
        s, w = numpy.polynomial.legendre.leggauss(3)
        self.points = (self.breaks[:-1, None] + 0.5 * length / n * (s + 1)).ravel()
        self.weights = numpy.tile(0.5 * length / n * w, n)
        self.values, self.slopes = self.at(self.points), self.at(self.points, 1)

    def at(self, x, derivative=0):
        spline = scipy.interpolate.BSpline(self.knots, numpy.eye(self.n + 2), 2)
        return (spline.derivative() if derivative else spline)(x)

    def control_values(self, nodal, axis):
        """From values at the ends and middles of the elements."""
        nodes = numpy.linspace(self.breaks[0], self.breaks[-1], 2 * self.n + 1)
        return numpy.moveaxis(numpy.tensordot(numpy.linalg.pinv(self.at(nodes)), nodal, (1, axis)), 0, axis)


def direction(dimension):
    b, p = numpy.radians(ANGLE), numpy.radians(AZIMUTH if dimension == 3 else 0.0)
    a = numpy.array([numpy.cos(b) * numpy.cos(p), numpy.cos(b) * numpy.sin(p), numpy.sin(b)])
    return a if dimension == 3 else a[[0, 2]]


def elastic(material, f):
    """Energy density of F, without fibres; F of any number of points."""
    d = f.shape[-1]
    c = numpy.swapaxes(f, -1, -2) @ f
    trace = numpy.einsum("...ii", c)
    if material == "neo_hookean":
        log = numpy.log(numpy.linalg.det(f))
        return 0.5 * SHEAR * (trace - d) - SHEAR * log + 0.5 * FIRST * log**2
    e = 0.5 * (c - numpy.eye(d))
    return 0.125 * FIRST * (trace - d)**2 + SHEAR * (e**2).sum(axis=(-1, -2))


def reinforced(f):
    moved = f @ direction(f.shape[-1])
    return 0.5 * FIBRES * ((moved**2).sum(axis=-1) - 1)**2


def surface(tangents):
    """Energy per undeformed area of the tangents, columns of (.., d, d - 1)."""
    metric = numpy.swapaxes(tangents, -1, -2) @ tangents
    return TENSION * (numpy.sqrt(numpy.linalg.det(metric)) - 1)


def slope_of(energy, at):
    """Derivative of an energy density by each component."""
    result = numpy.zeros(at.shape)
    for i, j in itertools.product(*map(range, at.shape[-2:])):
        step = at.astype(complex)
        step[..., i, j] += 1e-30j
        result[..., i, j] = energy(step).imag / 1e-30
    return result


class Layer:
    """The layer in the deformation of a run: energies, and their slopes along the control values, (.., d) each."""

    def __init__(self, run, about, material):
        self.about, self.material, self.d = about, material, len(about["elements"])
        self.axes = [Axis(length, n) for length, n in zip([1.0] * (self.d - 1) + [HEIGHT], about["elements"])]
        solid = _measure.field(run.folder, 0, "solid")
        nodal = numpy.moveaxis(numpy.asarray(solid.moved()).reshape(*[2 * n + 1 for n in about["elements"][::-1]], self.d),
                               range(self.d), range(self.d)[::-1])  # field files count along x first
        for axis, spline in enumerate(self.axes):
            nodal = spline.control_values(nodal, axis)
        self.u = nodal

    def spread(self, matrices, values):
        """sum over control values of the product of a matrix for each axis."""
        for axis, matrix in enumerate(matrices):
            values = numpy.moveaxis(numpy.tensordot(matrix, values, (1, axis)), 0, axis)
        return values

    def volume(self, energy):
        """An energy density of F: its integral and slope."""
        def matrices(j):
            return [axis.slopes if a == j else axis.values for a, axis in enumerate(self.axes)]

        f = numpy.stack([self.spread(matrices(j), self.u) for j in range(self.d)], axis=-1) + numpy.eye(self.d)
        weights = self.spread([numpy.diag(axis.weights) for axis in self.axes], numpy.ones(f.shape[:self.d]))
        p = slope_of(energy, f) * weights[..., None, None]
        return (energy(f) * weights).sum(), sum(self.spread([m.T for m in matrices(j)], p[..., j]) for j in range(self.d))

    def top(self):
        along = self.axes[:-1]

        def matrices(j):
            return [axis.slopes if a == j else axis.values for a, axis in enumerate(along)]

        row = self.u[..., -1, :]  # splines of the open end: the last row alone is the top
        tangents = numpy.stack([self.spread(matrices(j), row) for j in range(self.d - 1)], axis=-1) + numpy.eye(self.d)[:, :-1]
        weights = self.spread([numpy.diag(axis.weights) for axis in along], numpy.ones(tangents.shape[:self.d - 1]))
        p = slope_of(surface, tangents) * weights[..., None, None]
        slope = numpy.zeros_like(self.u)
        slope[..., -1, :] = sum(self.spread([m.T for m in matrices(j)], p[..., j]) for j in range(self.d - 1))
        return (surface(tangents) * weights).sum(), slope

    def forces(self, force, low, high):
        """Energy of a force on a box whose sides are sides of elements."""
        inside = [numpy.where((axis.points > a) & (axis.points < b), axis.weights, 0.0) @ axis.values
                  for axis, a, b in zip(self.axes, low, high)]
        weight = self.spread([part[:, None] for part in inside], numpy.ones([1] * self.d))
        slope = -weight[..., None] * numpy.array(force)
        return (slope * self.u).sum(), slope

    def parts(self):
        """{name: (energy, slope)}"""
        d, end = self.d, [1.0] * (self.d - 1) + [HEIGHT]
        return {"elasticity": self.volume(lambda f: elastic(self.material, f)), "fibres": self.volume(reinforced),
                "surface tension": self.top(), "gravity": self.forces([0.0] * (d - 1) + [WEIGHT], [0.0] * d, end),
                "load": self.forces(self.about["lift"], *self.about["box"])}

    def free(self, slope):
        """Slopes along what may move: not the base, not across the sides."""
        slope = slope.copy()
        slope[..., 0, :] = 0
        for axis in range(self.d - 1):
            for end in (0, -1):
                index = [slice(None)] * self.d + [axis]
                index[axis] = end
                slope[tuple(index)] = 0
        return slope


def study(lab):
    wanted = {f"{dimension}D, {material}": (dimension, material) for dimension in (2, 3)
              for material in ("saint_venant_kirchhoff", "neo_hookean")}
    scenes = {label: scene(*which) for label, which in wanted.items()}
    runs, rows = lab.runs({label: (text, []) for label, (_, text) in scenes.items()}), []
    for label, run in runs.items():
        layer = Layer(run, scenes[label][0], wanted[label][1])
        parts = layer.parts()
        sizes = {name: numpy.abs(layer.free(slope)).max() for name, (_, slope) in parts.items()}
        left = numpy.abs(layer.free(sum(slope for _, slope in parts.values()))).max()
        rows.append((label, f"{layer.u[..., -1].max():.3f}", *(f"{size:.1e}" for size in sizes.values()), f"{left:.1e}"))
        lab.expect(f"{label}: slope that is left, as a part of the smallest of any part", "<= 1e-9", f"{left / min(sizes.values()):.1e}",
                   left <= 1e-9 * min(sizes.values()))
        last = {name: values[-1] for name, values in run.history.items()}
        wanted_energies = {"energy_elastic": parts["elasticity"][0] + parts["fibres"][0], "energy_surface": parts["surface tension"][0],
                           "energy_gravity": parts["gravity"][0]}
        worst = max(abs(last[name] / value - 1) for name, value in wanted_energies.items())
        lab.expect(f"{label}: elastic, surface and gravity energies", "within 1e-12", f"{worst:.1e}", worst <= 1e-12)
    lab.text("Largest slope of each part of the energy along a control value that may move, and of their sum.")
    lab.table(("scene", "largest rise", *parts, "sum"), rows, "slopes")
