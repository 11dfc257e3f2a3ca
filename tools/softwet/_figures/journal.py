"""How the figures of the paper look: page width, colours that the colour-blind tell apart, panel letters, trends."""

from .._drawing import look
from .._drawing.look import np

WIDTH = 7.09  # two columns of the journal, inches
BLUE, VERMILION, GREEN, ORANGE = "#0072B2", "#D55E00", "#009E73", "#E69F00"  # after Okabe and Ito
SERIES = (BLUE, GREEN, ORANGE, VERMILION)
STYLE = {**look.STYLE, "font.size": 8, "axes.titlesize": 8, "axes.labelsize": 8, "legend.fontsize": 7, "xtick.labelsize": 7,
         "ytick.labelsize": 7, "axes.linewidth": 0.6, "lines.linewidth": 1.2, "xtick.major.width": 0.6, "ytick.major.width": 0.6,
         "legend.frameon": False, "legend.handlelength": 1.8}
TIME, X, Y = f"time {look.TIME}", look.length("x"), look.length("y")


def letter(axes, name):
    """The panel's letter above its upper left corner."""
    axes.set_title(name, loc="left", fontweight="bold", fontsize=9)


def trend(history, name, at, case):
    """A column of history.csv at the times `at`, averaged over the time in which the droplet passes one element.

    The mesh makes the column waver with the period of an element. The average reaches as far back in time as ahead,
    over half an element where the droplet is faster, and less at the ends of its way."""
    t, value, x = history["t"], history[name], history["x_centre"]
    way = np.maximum.accumulate(np.abs(x - x[0])) + 1e-12 * (t - t[0])  # rises always: one time for each position
    here = np.interp(at, t, way)
    half = np.minimum(0.5 * case["domain"]["size"][0] / case["domain"]["elements"][0], np.minimum(here, way[-1] - here))
    first, last = (np.interp(place, way, t) for place in (here - half, here + half))
    integral = np.append(0, np.cumsum(0.5 * (value[1:] + value[:-1]) * np.diff(t)))
    reach = np.minimum(at - first, last - at) + 1e-6
    first, last = np.maximum(at - reach, t[0]), np.minimum(at + reach, t[-1])
    return (np.interp(last, t, integral) - np.interp(first, t, integral)) / (last - first)
