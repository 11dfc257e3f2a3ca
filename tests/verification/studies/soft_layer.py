"""Wall under a droplet at rest against the linear theory of an elastic layer.

A droplet on a rigid wall exerts the traction t(x) (interface.csv). On a stiff layer the same traction displaces the
surface by u = C t, with the compliance C(k) of a layer of height H on a roller base in plane strain, which
tests/verification/_layer.py derives. Slip sides make its series exact: cosines for t_y, sines for t_x.

Half a droplet on a slip side. interface.csv holds a traction lumped over the splines of the wall; here it is turned
into the spline that does the same work on every spline (mass matrix). The rest vanishes with 1/E (deformed
geometry) and with h."""

import _layer
import _measure
import numpy
import scipy.interpolate
from _case import case, fields

MINUTES = {"quick": 0.4, "full": 1}
EXPLICIT = ("a state at rest, which no scheme changes (see laplace and free_droplet); to come to rest takes hundreds of units "
            "of time, and explicit steps are 1e-4 there")
LENGTH, HEIGHT, POISSON, YOUNG = 0.5, 0.125, 0.45, 0.7554


def half(n, g, young=None):
    """@param n  elements along the wall (0.5);  @param young  None: rigid wall"""
    substrate = {} if young is None else dict(substrate=dict(thickness=HEIGHT, young=young, poisson=POISSON))
    name, height, bottom, wall = ("soft", 0.5, "slip", HEIGHT) if substrate else ("rigid", 0.375, "no_slip", 0.0)
    return case("Half a droplet at rest; the left side is its plane of symmetry.", name,
                domain=dict(size=[LENGTH, height], elements=[n, round(n * height / LENGTH)]),
                fluid=dict(viscosity="1/256", capillarity=f"1/{g}", temperature=0.39, contact_angle=75.0),
                **substrate,
                droplet=[dict(centre=[0.0, wall], radius=0.155)],
                boundary=dict(bottom=bottom, top="no_slip"),
                time=dict(end=300.0),
                output=fields(300.0))


class WallSpline:
    """C1 quadratic splines on n elements of the wall."""

    def __init__(self, n):
        self.n, self.knots = n, numpy.concatenate(([0, 0], numpy.linspace(0, LENGTH, n + 1), [LENGTH, LENGTH]))
        x, w = numpy.polynomial.legendre.leggauss(6)
        h = LENGTH / n
        self.x = ((numpy.arange(n)[:, None] + 0.5 * (x + 1)) * h).ravel()
        self.w = numpy.tile(0.5 * h * w, n)
        self.values = self.matrix(self.x)

    def matrix(self, x):
        return scipy.interpolate.BSpline.design_matrix(x, self.knots, 2).toarray()

    def traction(self, x, lumped):
        """From the lumped traction at points x to the one with the same moments, at self.x."""
        moments = numpy.linalg.lstsq(self.matrix(x), lumped, rcond=None)[0] * (self.w @ self.values)
        return self.values @ numpy.linalg.solve(self.values.T @ (self.w[:, None] * self.values), moments)


def linear_theory(run, n, young, x):
    """Displacement (u_x, u_y) at the points x from the traction on the rigid wall."""
    wall, spline = _measure.interface(run.folder), WallSpline(n)
    t = [spline.traction(wall["x_reference"], wall[f"traction_{d}"]) for d in "xy"]
    u = numpy.zeros((2, len(x)))
    for m in range(n):
        k, norm = m * numpy.pi / LENGTH, (1 if m == 0 else 2) / LENGTH
        sine, cosine = (norm * (spline.w * wave(k * spline.x) * f).sum() for wave, f in ((numpy.sin, t[0]), (numpy.cos, t[1])))
        part = _layer.compliance(k, HEIGHT, young, POISSON) @ (sine, cosine)
        u += numpy.stack((part[0] * numpy.sin(k * x), part[1] * numpy.cos(k * x)))
    return u


def check_compliance(lab):
    worst = 0.0
    for k in numpy.pi / LENGTH * numpy.array([1, 5, 20]):
        z = 2 * k * HEIGHT
        book = 2 * (1 - POISSON**2) / (YOUNG * k) * (numpy.cosh(z) - 1) / (numpy.sinh(z) + z)
        c = _layer.compliance(k, HEIGHT, YOUNG, POISSON)
        worst = max(worst, abs(c[1, 1] / book - 1), abs(c[0, 1] - c[1, 0]) / book)
    lab.expect("compliance: u_y/t_y as in the textbook, reciprocal", "1e-12", f"{worst:.1e}", worst <= 1e-12)


def compare(lab, rigid, soft, n, young, rows):
    """Adds a row; @return the largest error of the profiles, as parts of the ridge"""
    wall = _measure.interface(soft.folder)
    x, u = wall["x_reference"], numpy.stack([wall["displacement_x"], wall["displacement_y"]])
    theory = linear_theory(rigid, n, young, x)
    features = [(v.max(), v[0], v[-1]) for v in (u[1], theory[1])]
    off = [100 * (a / b - 1) for a, b in zip(*features)]
    worst = numpy.abs(u - theory).max(axis=1) / theory[1].max()
    waves = numpy.cos(numpy.outer(numpy.pi / LENGTH * numpy.array([1, 2, 4, 8]), x[:-1])) @ numpy.stack([u[1], theory[1]], axis=1)[:-1]
    waves = (waves[:, 0] - waves[:, 1]) / numpy.abs(waves[:, 1]).max()
    rows.append((n, f"{young / YOUNG:g}", f"{features[1][0] / (YOUNG / young):.3e}", *(f"{o:+.2f} %" for o in off),
                 *(f"{100 * a:+.2f} %" for a in waves), *(f"{100 * w:.2f} %" for w in worst)))
    return worst, off, (x, u, theory)


def study(lab):
    check_compliance(lab)
    meshes = ((32, 32),) if lab.quick else ((32, 32), (64, 32), (64, 64))
    factors = (50,) if lab.quick else (1, 10, 50)
    wanted = {}
    for n, g in meshes:
        wanted[f"rigid, n = {n}, 1/gamma = {g}"] = (half(n, g), [])
        for factor in factors if g < 64 else (10,):
            wanted[f"E x {factor}, n = {n}, 1/gamma = {g}"] = (half(n, g, YOUNG * factor), [])
    runs, rows, results = lab.runs(wanted, limit=1500), [], {}
    for n, g in meshes:
        for factor in factors if g < 64 else (10,):
            mine = []
            results[n, g, factor] = compare(lab, runs[f"rigid, n = {n}, 1/gamma = {g}"],
                                            runs[f"E x {factor}, n = {n}, 1/gamma = {g}"], n, YOUNG * factor, mine)
            rows.append((g, *mine[0]))
    lab.table(("1/gamma", "n", "E / 0.7554", "ridge x E / 0.7554", "ridge", "middle", "far side", "k_1", "k_2", "k_4", "k_8",
               "profile u_x", "profile u_y"), rows, "layer")
    lab.text("Ridge (largest u_y), middle of the droplet, far side and Fourier cosines k_m = m pi/0.5 of u_y: softwet against the "
             "linear theory; the coefficients as a part of the largest of them. Profile: largest difference as a part of the ridge.")
    n, g = (32, 32) if lab.quick else (64, 32)
    worst, off, profile = results[n, g, 50]
    for what, value in zip(("ridge", "middle", "far side"), off):
        lab.expect(f"E x 50, n = {n}: {what}", "linear theory +- 3 %", f"{value:+.2f} %", abs(value) <= 3)
    lab.expect(f"E x 50, n = {n}: profiles of u_x and u_y", "within 3 % of the ridge",
               " and ".join(f"{100 * w:.2f} %" for w in worst), worst.max() <= 0.03)
    if not lab.quick:
        soft = [results[n, g, factor][0].max() for factor in factors]
        lab.expect("profile, E x 10 / E x 1", "<= 0.3", f"{soft[1] / soft[0]:.2f}", soft[1] <= 0.3 * soft[0])

    def draw(axes):
        x, u, theory = profile
        for name, a, b in zip("xy", u, theory):
            line, = axes.plot(x, a, label=f"u_{name}, softwet")
            axes.plot(x, b, "--", color=line.get_color(), label="linear theory")
        axes.set(xlabel="x", ylabel="displacement", title=f"E x 50, n = {n}, gamma = 1/{g}")
        axes.legend()
    lab.plot("profile", draw)
