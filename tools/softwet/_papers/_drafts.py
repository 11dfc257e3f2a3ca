"""Drafts on two meshes: the same sweep on each, and the speed of every droplet with an error bar.

The bar is the difference of the two meshes, whose elements have the lengths h and h/2. Where the error falls as h^2, the finer mesh,
whose speed is taken, is a third of the bar away from the limit (Richardson).

How fast a force drives a droplet is measured too: on a layer that drives it nowhere, by a wall whose wetting grows along it. So the speed
of a droplet becomes its drive: the difference of contact angles that moves it as fast. Formulas give drives."""

import math

import softwet
from softwet._drawing.look import np

from softwet._figures.journal import BLUE, GREEN, ORANGE, VERMILION
from softwet._papers._oracle import oracle

MESHES = {"coarse": 64, "fine": 128}  # elements along the box; the interface has two and four of them in its half width
QUICK = 32                            # on which a run takes a second
THICKNESS, RADIUS, CAPILLARITY = 0.125, 0.16, 1 / 32
PULL = 0.2                            # growth of cos(contact angle) along the wall that pulls
HEADER = ("speed_coarse", "speed_fine", "error", "drive", "drive_error", "drive_work", "drive_slopes")


# --- runs ----------------------------------------------------------------------------------------------------------
def tables(name, elements, fluid, substrate, **sides):
    """The case of a droplet on a layer, a draft. @param elements  along the box"""
    end = 3.0 if elements == QUICK else 30.0
    return {
        "name": name, "quality": "draft",
        "domain": {"size": [1.0, 0.5], "elements": [elements, elements // 2]},
        "fluid": {"viscosity": 1 / 256, "capillarity": max(CAPILLARITY, 2 / elements), "temperature": 0.39, "wall_law": "energy", **fluid},
        "substrate": {"thickness": THICKNESS, **substrate},
        "droplet": [{"centre": [0.5, THICKNESS], "radius": RADIUS}],
        "boundary": {"left": "slip", "right": "slip", "bottom": "clamped", "top": "no_slip", **sides},
        "time": {"end": end},
        "output": {"fields": {"times": [end]}},
    }


def sweep(runs, name, make, vary, more=()):
    """Computes a sweep on each mesh, in the folders NAME_MESH. @param make  the tables of a case for (name, elements);
    vary  {key: values};  more  words of the command"""
    words = [word for key, values in vary.items() for word in ("--vary", f"{key}={','.join(map(str, values))}")]
    for mesh, elements in {"coarse": QUICK}.items() if runs.quick else MESHES.items():
        runs.softwet("sweep", runs.write_case(make(f"{name}_{mesh}", elements)), *more, *words, out=f"{name}_{mesh}")


def pulled(angle):
    """A contact angle whose cosine grows along the wall. @param angle  in the middle"""
    return f"acos(cos({angle}*pi/180) + {PULL}*sin(2*pi*(x - 0.5))/(2*pi))*180/pi"


def pulled_at(angle, x):
    return np.degrees(np.arccos(math.cos(math.radians(angle)) + PULL * np.sin(2 * math.pi * (x - 0.5)) / (2 * math.pi)))


# --- what they show ------------------------------------------------------------------------------------------------
class Droplet:
    """A droplet on one mesh or two, from a third of the time to the end.

    speeds, speed, error;  drive, drive_error  in degrees, nan where no droplet was pulled;  formulas  {name: drive}"""

    def __init__(self, runs):
        self.runs = runs
        self.speeds = [speed(run) for run in runs]
        self.speed = self.speeds[-1]
        self.error = abs(self.speed - self.speeds[0])
        self.drive = self.drive_error = math.nan
        self.formulas = {}

    def driven(self, mobilities):
        """@param mobilities  speed over drive on the same meshes, or None"""
        if not mobilities:
            return
        drives = [speed / mobility for speed, mobility in zip(self.speeds, mobilities)]
        self.drive, self.drive_error = drives[-1], abs(drives[-1] - drives[0])

    def foretold(self, layer, angle):
        """@param layer  as in tests/oracle/driven_droplet.py"""
        ends = [mean(self.runs[-1].history, self.runs[-1].history[name]) for name in ("x_left", "x_right")]
        capillarity = self.runs[-1].case["fluid"]["capillarity"]
        self.formulas = dict(zip(("slopes", "work"), layer.drive(angle, capillarity, *ends)))

    def row(self):
        """Its columns of HEADER, empty where there is none."""
        speeds = [*self.speeds, math.nan][:2]
        drives = self.drive, self.drive_error, self.formulas["work"], self.formulas["slopes"]
        return [*("" if math.isnan(value) else f"{value:.4e}" for value in speeds), f"{self.error:.1e}",
                *("" if math.isnan(value) else f"{value:.4f}" for value in drives)]


def window(history):
    return history["t"] >= history["t"][-1] / 3


def speed(run):
    t, x = (run.history[name][window(run.history)] for name in ("t", "x_centre"))
    return (x[-1] - x[0]) / (t[-1] - t[0])


def mean(history, values):
    t, value = history["t"][window(history)], values[window(history)]
    return 0.5 * (value[1:] + value[:-1]) @ np.diff(t) / (t[-1] - t[0])


def droplets(folder, name):
    """{values of --vary: Droplet} of a sweep on its meshes, {} without one; a tuple, or the value itself where one key
    is varied."""
    sweeps = [softwet.open_sweep(folder / f"{name}_{mesh}") for mesh in MESHES if (folder / f"{name}_{mesh}").is_dir()]
    runs = {}
    for member in (member for members in sweeps for member in members):
        values = tuple(member.values.values())
        runs.setdefault(values if len(values) > 1 else values[0], []).append(member.run)
    return {values: Droplet(chosen) for values, chosen in runs.items()}


def mobilities(folder, name, angle_of):
    """{value of --vary: speed over drive on each mesh} of droplets that are pulled. @param angle_of  the contact angle
    of a value"""
    found = {}
    for value, droplet in droplets(folder, name).items():
        histories, angle = [run.history for run in droplet.runs], angle_of(value)
        differences = [mean(rows, pulled_at(angle, rows["x_left"]) - pulled_at(angle, rows["x_right"])) for rows in histories]
        found[value] = [speed / difference for speed, difference in zip(droplet.speeds, differences)]
    return found


def layer(*of):
    return oracle("driven_droplet").Layer(*of)


# --- agreement and picture -----------------------------------------------------------------------------------------
STRAINS = "strains are not small"
POINTS = "it has neither the width of the interface nor the pressure"


def judged(good, why):
    return "agrees" if good else f"does not: {why}"


def compared(what, droplet, formula, why):
    """The drive against a formula, as a row of agreement. @param why  what the formula leaves out"""
    told, bar = droplet.formulas[formula], droplet.drive_error
    off = abs(droplet.drive - told)
    return (f"drive, {what}", f"{told:+.3f} degrees, {formula}", f"{droplet.drive:+.3f} ± {bar:.3f} degrees",
            judged(off < 0.1 * abs(told) + bar, f"{droplet.drive / told:.2f} of it, {why}"))


def draw_speeds(axes, droplets, colour, label):
    """@param droplets  {abscissa: Droplet}"""
    axes.errorbar(list(droplets), [1e3 * droplet.speed for droplet in droplets.values()],
                  [1e3 * droplet.error for droplet in droplets.values()], fmt="o-", markersize=3.5, color=colour, label=label)
    axes.set(ylabel=r"speed $\;/\; 10^{-3} \sqrt{ab}$")


def draw_drives(axes, droplets, label):
    """Drives and their formulas. @param droplets  {abscissa: Droplet}"""
    for name, colour, dashes in (("work", BLUE, "--"), ("slopes", VERMILION, ":")):
        axes.plot(list(droplets), [droplet.formulas[name] for droplet in droplets.values()], dashes, color=colour, label=f"formula: {name}")
    draw_found(axes, droplets, 1, "o", GREEN, label)
    axes.axhline(0, color="0.6", linewidth=0.6)
    axes.set(ylabel="drive, degrees")


def draw_more(axes, droplets, factor, label):
    """Drives of another solid, times a factor."""
    draw_found(axes, droplets, factor, *(("^", "0.4") if factor == 1 else ("s", ORANGE)), label)


def draw_legend(axes):
    """A legend above the curves."""
    low, high = axes.get_ylim()
    axes.set_ylim(low, high + 0.5 * (high - low))
    axes.legend(loc="upper left")


def draw_found(axes, droplets, factor, marker, colour, label):
    axes.errorbar(list(droplets), [factor * droplet.drive for droplet in droplets.values()],
                  [factor * droplet.drive_error for droplet in droplets.values()], fmt=marker, markersize=3.5, color=colour, label=label)
