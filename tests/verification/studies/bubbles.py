"""Three vapour bubbles in liquid: the coalescence case of the literature.

Periodic unit square, theta = 0.85, viscosity gamma_hat/2, bubbles of radius 0.10, 0.15, 0.08 at (0.75, 0.50), (0.25, 0.50),
(0.40, 0.75), densities 0.1 and 0.6 at the start: H. Gomez, T.J.R. Hughes, X. Nogueira, V.M. Calo, Isogeometric analysis of
the isothermal Navier-Stokes-Korteweg equations, CMAME 199 (2010), and demo/NavierStokesKorteweg2D.c of PetIGA; the demo
names no times of events, the text of the paper was not at hand. Energy here: int W + g^2/2 |grad rho|^2 + rho |v|^2/2 (the demo's has |v|^2/2 without the density, which no
law makes fall). Known: it may only fall (no walls, no loads), mass and momentum are constant, and the vapour ends as one
round bubble. The start has the profile of the plane interface, a little wider than the demo's 2 gamma_hat.
Counted at every field time: separate pieces of vapour (rho < (rho_v + rho_l)/2), across the periodic sides.
The smaller bubbles vanish into the largest through the liquid, without touching it: the smallest by t = 2.5 on 128 x 128
elements and by t = 4.5 on 256 x 256."""

import _measure
import numpy
from _case import case, fields, sides
from plane_interface import PlaneInterface

MINUTES = {"quick": 0.1, "full": 9}
CASE = case("Three bubbles of vapour in a periodic square of liquid, after Gomez et al. 2010.", "three_bubbles",
            domain=dict(size=[1.0, 1.0], elements=[64, 64]),
            fluid=dict(viscosity="1/128", capillarity="1/64", temperature=0.85, ambient="liquid", initial=[0.1, 0.6]),
            droplet=[dict(centre=[0.75, 0.5], radius=0.1), dict(centre=[0.25, 0.5], radius=0.15),
                     dict(centre=[0.4, 0.75], radius=0.08)],
            boundary=sides("periodic"),
            time=dict(end=5.0),
            output=fields(5.0))


def pieces(vapour):
    """Areas of the connected pieces of a periodic boolean picture, as parts of the square, largest first."""
    label = numpy.where(vapour, numpy.arange(vapour.size).reshape(vapour.shape), -1)
    while True:
        spread = label
        for axis in (0, 1):
            for shift in (-1, 1):
                spread = numpy.where(vapour, numpy.maximum(spread, numpy.roll(spread, shift, axis)), -1)
        if (spread == label).all():
            break
        label = spread
    _, counts = numpy.unique(label[vapour], return_counts=True)
    return sorted((counts / vapour.size).tolist(), reverse=True)


def study(lab):
    n, end, count = (48, 2, 8) if lab.quick else (256, 6, 24)
    times = [float(f"{end * i / count:.4g}") for i in range(count + 1)]
    run = lab.run(f"{n} x {n}", CASE, [f"domain.elements=[{n},{n}]", f"fluid.capillarity=1/{n}", f"fluid.viscosity=1/{2 * n}",
                                       f"time.end={end}", f"output.fields.times=[{','.join(map(str, times))}]"], limit=3500)
    history, plane = run.history, PlaneInterface(0.85)
    energy, level = history["energy_total"], 0.5 * (plane.vapour + plane.liquid)
    pictures = [_measure.fluid_field(run.folder, i)[1][:-1, :-1] for i in range(len(times))]
    areas = [pieces(rho < level) for rho in pictures]
    rise = numpy.diff(energy).max()
    lab.expect("energy, largest change over a step", "<= 0", f"{rise:.2g} of {energy[0] - energy[-1]:.3g} lost", rise <= 0)
    parts = history["energy_free"] + history["energy_kinetic"]
    lab.expect("energy_total - free - kinetic", "<= 1e-15", f"{numpy.abs(energy - parts).max():.1g}",
               numpy.abs(energy - parts).max() <= 1e-15)
    drift = numpy.abs(history["mass_drift"]).max()
    lab.expect("drift of the mass", "<= 1e-10", f"{drift:.1g}", drift <= 1e-10)
    momentum = numpy.abs(history["momentum_x"]).max()
    scale = history["mass"][0] * history["speed_max_fluid"].max()
    lab.expect("x-momentum over mass times largest speed", "<= 1e-3", f"{momentum / scale:.1e}", momentum <= 1e-3 * scale)
    counts = [len(area) for area in areas]
    lab.expect("separate bubbles at the start", 3, counts[0], counts[0] == 3)
    lab.expect("their number", "never grows", " ".join(map(str, counts)), (numpy.diff(counts) <= 0).all())
    lab.title("Events")
    events = [i for i in range(len(times)) if i == 0 or counts[i] != counts[i - 1] or i == len(times) - 1]
    lab.table(("t", "bubbles", "areas", "energy", "kinetic"), [(
        times[i], counts[i], " ".join(f"{area:.4f}" for area in areas[i]), f"{numpy.interp(times[i], history['t'], energy):.9f}",
        f"{numpy.interp(times[i], history['t'], history['energy_kinetic']):.2e}") for i in events], "events")
    lab.text(f"{n} x {n} elements, gamma_hat = 1/{n}, to t = {end}: {run.record['counts']['steps']} steps, {run.seconds:.0f} s.")
    if not lab.quick:
        lab.plot("energy", lambda axes: (axes.plot(history["t"], energy), axes.set(xlabel="t", ylabel="energy")))
        draw(lab, times, pictures, events)


def draw(lab, times, pictures, events):
    try:
        import matplotlib
    except ImportError:
        return
    matplotlib.use("Agg")
    from matplotlib import pyplot
    chosen = sorted({0, *events, len(times) // 4, len(times) // 2})[:6]
    figure, every = pyplot.subplots(1, len(chosen), figsize=(2.2 * len(chosen), 2.5), layout="constrained")
    for axes, i in zip(every, chosen):
        axes.imshow(pictures[i], origin="lower", extent=(0, 1, 0, 1), cmap="viridis", vmin=0.1, vmax=0.62)
        axes.set(title=f"t = {times[i]:g}", xticks=[], yticks=[])
    figure.savefig(lab.folder / "bubbles_density.png", dpi=80)
    pyplot.close(figure)
    lab.picture("bubbles_density.png")


def explicit(lab):
    """The quick form of the study: 48 x 48 elements to t = 2."""
    study(lab)
