"""Oscillation of a free droplet in its second mode, two dimensions.

A quarter of a droplet between slip sides starts as an ellipse. Its half axis on the bottom side, less the half axis of the same
droplet started as a circle (the profile settles, the vapour fills), is fitted by a damped wave.
Lamb's sharp answer: omega^2 = n (n^2 - 1) sigma/((rho_l + rho_v) R^3), damping 2 n (n - 1) nu/R^2, n = 2. The best
answer is the eigenvalue of the linearised Navier-Stokes-Korteweg equations about the exact droplet of the same mass
(tests/oracle/droplet_modes.py): interface of finite width, both phases viscous and compressible, evaporation. What is
left out of it: the vapour ends at a square, not a disc of radius 0.5 (its density is 1/641 of the liquid's: relative
change of the frequency (R/L)^4 rho_v/rho_l = 4e-5), the amplitude (2 %: second order, 4e-4), and the step (second
order). The stabilisation eps is off: it damps by about eps omega^2/(2 rho_l), 5e-3 at h = 1/64."""

import _shape
import droplet_modes
import numpy
from _case import case, fields
from _lab import Known
from _measure import radial_droplet

MINUTES = {"quick": 0.2, "full": 0.8}
RADIUS, VISCOSITY = 0.2, 3e-4
CASE = case("A quarter of an elliptic droplet; left and bottom sides are planes of symmetry.", "oscillation",
            domain=dict(size=[0.5, 0.5], elements=[64, 64]),
            fluid=dict(viscosity=3e-4, capillarity="1/64", temperature=0.39, contact_angle=90.0, stabilisation=0.0),
            droplet=[dict(centre=[0.0, 0.0], radius=0.2, stretch=[1.02, 0.98])],
            boundary=dict(top="slip"),
            time=dict(end=7.0, tolerance=1e3),
            output=fields())


def settings(g, elements, step, end):
    return [f"fluid.capillarity=1/{g}", f"domain.elements=[{elements},{elements}]", f"time.dt_initial={step}",
            f"time.dt_max={step}", f"time.end={end}"]


ROUND = ["droplet[0].stretch=[1,1]"]


def answers(run, still, g):
    """Lamb's and the best answer for the mass of the run, and what was measured."""
    mass = 4 * run.history["mass"][-1]
    middle = radial_droplet.solve(1 / g, mass, volume=1.0)[3]
    lamb = droplet_modes.sharp(1 / g, VISCOSITY, 0.39, middle)
    # The vapour of the square beyond the disc is not part of the disc's mass.
    inside = mass - (1 - numpy.pi / 4) * radial_droplet.solve(1 / g, mass, volume=1.0)[1]
    best = droplet_modes.oscillation(1 / g, VISCOSITY, 0.39, inside, 0.5, lamb, points=300)
    t = run.history["t"]
    wave = run.history["x_right"] - numpy.interp(t, still.history["t"], still.history["x_right"])
    seen = t > 2  # before, faster modes of the start ring
    found, left = _shape.damped_wave(t[seen], wave[seen], best)
    return lamb, best, found, left, middle


def study(lab):
    step, end = (0.05, 7) if lab.quick else (0.03, 9)
    cases = {"gamma_hat = 1/32, h = 1/64": (32, 32)} if lab.quick else {
        "gamma_hat = 1/32, h = 1/64": (32, 32), "gamma_hat = 1/64, h = 1/128": (64, 64)}
    wanted = {label: (CASE, settings(g, n, step, end)) for label, (g, n) in cases.items()}
    wanted |= {f"{label}, circle": (case, words + ROUND) for label, (case, words) in wanted.items()}
    runs, rows = lab.runs(wanted, limit=3000), []
    for label in cases:
        run = runs[label]
        g, _ = cases[label]
        lamb, best, found, left, radius = answers(run, runs[f"{label}, circle"], g)
        rows.append((label, f"{radius:.4f}", f"{lamb.imag:.4f}", f"{best.imag:.4f}", f"{found.imag:.4f}", f"{-lamb.real:.4f}",
                     f"{-best.real:.4f}", f"{-found.real:.4f}", f"{left:.0e}"))
        error = found.imag / best.imag - 1
        lab.expect(f"{label}: frequency", f"{best.imag:.4f} +- 1 %", f"{found.imag:.4f}, {100 * error:+.2f} %", abs(error) <= 0.01)
        lab.expect(f"{label}: damping", f"{-best.real:.4f} +- 10 %", f"{-found.real:.4f}", abs(found.real / best.real - 1) <= 0.1)
    lab.table(("run", "R", "frequency, Lamb", "best answer", "run", "damping, Lamb", "best answer", "run", "misfit"), rows, "modes")


CAUSE = "two elements to a capillarity are coarse for corrected masses; their error falls with the mesh, see the last rows"
MISSED = {32: (0.02, 0.25), 16: (0.005, 0.03)}  # of frequency and damping, by 1/gamma_hat


def explicit(lab):
    """A quarter of the droplet on 32 x 32 elements to t = 7, with two and with four elements to a capillarity, against
    generalized_alpha on the same mesh."""
    off = []
    for g in (32, 16):
        words, found = settings(g, 32, 0.05, 7), {}
        for scheme in ("generalized_alpha", lab.scheme):
            label = f"gamma_hat = {64 // g} h" + (", implicit" if scheme != lab.scheme else "")
            run, still = (lab.run(name, CASE, [*more, f"time.scheme={scheme}"])
                          for name, more in ((label, words), (f"{label}, circle", words + ROUND)))
            _, best, found[scheme], *_ = answers(run, still, g)
        exact, wave = found.values()
        off.append((abs(wave.imag / exact.imag - 1), abs(wave.real / exact.real - 1)))
        for i, (what, part, bound) in enumerate((("frequency", "imag", 0.01), ("damping", "real", 0.1))):
            worst = MISSED[g][i]
            mine, asked, theory = (abs(getattr(value, part)) for value in (wave, exact, best))
            lab.expect(f"{label}: {what}", f"{asked:.4f} +- {100 * bound:g} %, by theory {theory:.4f}",
                       f"{mine:.4f}, {100 * (mine / asked - 1):+.2g} %", off[-1][i] <= bound,
                       Known(CAUSE, f"off by {100 * worst:.2g} %", off[-1][i] <= worst))
    for i, what in enumerate(("frequency", "damping")):
        ratio = off[1][i] / off[0][i]
        lab.expect(f"error of the {what}, four elements to a capillarity over two", "<= 1/3", f"{ratio:.2g}", ratio <= 1 / 3)
