#!/usr/bin/env python3
"""Fast scenes near the critical temperature, small: explicit schemes come to the end that generalized_alpha with fine
steps comes to, keep the mass to rounding, and let the total energy fall at every row once the start has settled. Sound
has the speed of the equation of state. time.scheme = "automatic" takes the scheme for the number of steps.
usage: fast_scenes.py SOFTWET"""

import math
import pathlib
import tomllib

import numpy
from _scene import PULL, cases, check, check_true, history, open_output, record, run

BOTH = ["domain.quadrature=full", "output.history.every=1"]
IMPACT = [*BOTH, "domain.elements=[40,25]", "fluid.capillarity=1/24", "time.end=2", "output.fields.times=[2]"]
SWING = [*BOTH, "domain.elements=[32,32]", "fluid.capillarity=1/28", "time.end=3", "output.fields.times=[3]"]
# name: settings, size of the fine steps, and what the errors in space of the masses may change at the end: parts of the
# energy that was dissipated, of the kinetic energy, and of the density step (rms). Those of corrected masses are two to
# three times what was measured.
SCENES = {
    "impact_rigid_2d": (IMPACT, 0.01, {"lumped": (0.05, 0.15, 0.03), "corrected": (0.006, 0.008, 0.0012)}),
    "oscillating_droplet_2d": (SWING, 0.02, {"lumped": (0.015, 0.05, 0.002), "corrected": (0.003, 0.003, 0.0002)}),
}
STEP = 0.6023801 - 0.1065767  # of the density at the temperature 0.85, tests/oracle/plane_interface.py


def compute(scene, name, settings):
    run(scene, name, settings)
    rows = history(name)
    end = open_output(name).fields(rows["t"][-1])
    return rows, end["density"]


def fall(rows):
    return rows["energy_total"][0] - rows["energy_total"][-1]


def compare(scene, settings, dt, allowed):
    fine = ["time.scheme=generalized_alpha", "time.tolerance=1e30", f"time.dt_initial={dt}", f"time.dt_max={dt}",
            "solver.newton.rtol=1e-9"]
    expected, density = compute(scene, f"{scene}_fine", settings + fine)
    for scheme in ("kick_drift", "rkl2", "ssp_rk3"):
        for mass, (of_fall, of_kinetic, of_density) in allowed.items():
            name = f"{scene}_{scheme}_{mass}"
            rows, found = compute(scene, name, [*settings, f"time.scheme={scheme}", f"time.mass={mass}"])
            check(f"{name}: energy dissipated", abs(fall(rows) / fall(expected) - 1), of_fall)
            kinetic = rows["energy_kinetic"][-1] / expected["energy_kinetic"][-1]
            check(f"{name}: kinetic energy at the end", abs(kinetic - 1), of_kinetic)
            check(f"{name}: density at the end, rms", numpy.sqrt(((found - density)**2).mean()) / STEP, of_density)
            check(f"{name}: drift of the mass", abs(rows["mass_drift"]).max(), 1e-12)
            settled = rows["t"][1:] > 0.1  # before, the start settles while steps still grow (docs/fast_scenes.md)
            check(f"{name}: largest rise of the total energy in a step", numpy.diff(rows["energy_total"])[settled].max(), 0)
            check(f"{name}: refused steps", record(name)["counts"]["rejected_by_newton"], 0)


def pulse(x, t, c, rho, height, capillarity=1 / 32, viscosity=4e-4):
    """Exact small waves of the fluid at rest that start as height cos(pi x/4)^16, the sum over k of (C(16, 8 - k)/2^15,
    half of it for k = 0) cos(q x), q = k pi/2: each swings with s^2 + 2 d s + w^2 = 0, w^2 = c^2 q^2 + rho g^2 q^4 and
    d = (2/3)(m/rho) q^2, and starts with the velocity 0."""
    total = height * math.comb(16, 8) / 2**16 + 0 * x
    for k in range(1, 9):
        q = k * math.pi / 2
        d = 2 / 3 * viscosity / rho * q**2
        w = math.sqrt((c * q)**2 + rho * (capillarity * q**2)**2 - d**2)
        swing = math.exp(-d * t) * (math.cos(w * t) + d / w * math.sin(w * t))
        total += height * math.comb(16, 8 - k) / 2**15 * swing * numpy.cos(q * x)
    return total


def check_sound():
    """The pulse of the case, a twentieth as high, at t = 1.5, less the same run without pulse, above the droplet and
    left of what it sends back. The speed of sound with which small waves come closest is the one of the equation of
    state but for the squares of the height (0.3 %) and of the mesh size."""
    t, share = 1.5, 0.05
    settings = [*BOTH, "domain.elements=[96,24]", "fluid.capillarity=1/32", f"time.end={t}", f"output.fields.times=[{t}]"]
    waves = tomllib.loads((cases / "sound_pulse_2d.toml").read_text())["wave"]
    for name, part in (("pulse", share), ("still", 0)):
        run("sound_pulse_2d", name,
            settings + [f"wave[{i}].amplitude={part * wave['amplitude']}" for i, wave in enumerate(waves)])
    fields = [open_output(name).fields(t) for name in ("pulse", "still")]
    x = fields[0].reference[-1, :, 0]
    seen, rise = x < 0.7, (fields[0]["density"] - fields[1]["density"])[-1]
    rho = history("still")["rho_min"][0]
    exact = math.sqrt(8 / 27 * 0.85 / (1 - rho)**2 - 2 * rho)
    tried = numpy.linspace(0.9 * exact, 1.1 * exact, 401)
    errors = [((pulse(x, t, c, rho, 0.008 * share) - rise)[seen]**2).sum() for c in tried]
    speed = tried[numpy.argmin(errors)]
    check(f"speed of sound {speed:.4f}, by the equation of state {exact:.4f}: relative error", abs(speed / exact - 1), 0.01)


def check_automatic():
    """What time.scheme = "automatic" takes, and what is written of it."""
    for case, settings, scheme, words in (
            ("impact_rigid_2d", [*IMPACT, "time.end=0.1", "output.fields.times=[0.1]"], "kick_drift", "explicit steps, of which up to 1300"),
            ("tensotaxis_pull_2d", PULL, "generalized_alpha", "explicit steps, of which up to 1300"),
            ("impact_soft_2d", ["domain.elements=[24,18]", "fluid.capillarity=1/18", "time.end=0.1", "output.fields.times=[0.1]",
                                "substrate.inertia=none"], "generalized_alpha", "do not support what this case asks for")):
        said = run(case, "chosen", [*settings, "time.scheme=automatic"])
        check_true(f"{case}: automatic takes {scheme}", f"takes {scheme}: " in said and words in said, said.strip())
        written = tomllib.loads(pathlib.Path("chosen/case.toml").read_text())["time"]["scheme"]
        check_true(f"{case}: case.toml has {scheme}", written == scheme, written)


    # A run that goes on keeps the scheme that it began with.
    settings = [*IMPACT, "time.end=0.1", "output.fields.times=[]"]
    run("impact_rigid_2d", "longer", [*settings, "time.scheme=automatic"])
    run("impact_rigid_2d", "longer", [*settings, "time.end=1000", "time.max_steps=20", "time.scheme=automatic"], ("--resume", "--quiet"))
    check_true("a run that is resumed keeps its scheme", history("longer")["step"][-1] == 20, history("longer")["step"][-1])


for scene, numbers in SCENES.items():
    compare(scene, *numbers)
check_sound()
check_automatic()
