#!/usr/bin/env python3
"""Solids with a tense and elastic surface, viscosity, weight, fibres, a foundation, a stiffness and a wetting that
vary, also with stretch, under a load or a needle that moves: the same bits on any number of processes; and of solids
that are stretched before or viscoelastic.
usage: solids.py SOFTWET"""

from _ranks import check_same, run

SCENE = ["domain.elements=[44,16]", "fluid.capillarity=1/16", "fluid.temperature=0.7", "load[0].start=0.01",
         "load[0].ramp=0.01", "output.fields.times=[0,0.02]", "output.history.every=1", "time.end=0.02",
         "fluid.wall_law=energy", "fluid.wall_tension=acts", "fluid.contact_angle=75 + 20*x", "substrate.surface_tension=0.03",
         "substrate.viscosity=0.01", "substrate.gravity=[0.01,-0.02]", "substrate.fibre.stiffness=0.2", "substrate.fibre.angle=30",
         "substrate.young=0.7*exp(x - 0.5)", 'load[0].path=["5*t",0]', "load[0].factor=cos(t)",
         "substrate.surface_modulus=[0.02,0.01]", "boundary.bottom=free", "boundary.foundation=[5,1]",
         "boundary.foundation_damping=[0.1,0.2]", "fluid.wall_stretch_exponent=0.5"]
AROUND = ["boundary.left=periodic", "boundary.right=periodic"]
EXPLICIT = ["time.scheme=kick_drift"]
STRETCHED = ["substrate.prestretch=[1.2]", 'substrate.material="neo_hookean"', "substrate.fibre.angle=0"]
RUNS = {"implicit": [], "explicit": EXPLICIT, "implicit_around": AROUND, "explicit_around": [*AROUND, *EXPLICIT],
        "stretched": STRETCHED, "stretched_explicit": [*STRETCHED, *EXPLICIT]}

for name, settings in RUNS.items():
    for count in (1, 3):
        run(count, "tensotaxis_pull_2d", f"{name}_{count}", [*SCENE, *settings])
    check_same(f"{name}, 3 processes", f"{name}_3", f"{name}_1")
NEEDLE = ["domain.elements=[44,16]", "fluid.capillarity=1/16", "fluid.temperature=0.7", "output.fields.times=[0,0.02]",
          "output.history.every=1", "time.end=0.02", "time.start=initial", 'needle.path=["0.1*t","-0.05*t"]']
for name, settings in {"needle": [], "needle_explicit": [*AROUND, *EXPLICIT]}.items():
    for count in (1, 3):
        run(count, "pulled_needle_2d", f"{name}_{count}", [*NEEDLE, *settings])
    check_same(f"{name}, 3 processes", f"{name}_3", f"{name}_1")
SLOW = [s for s in SCENE if "substrate.young" not in s] + ["substrate.gel.exponent=0.5", "substrate.gel.time=0.01"]
for name, settings in {"gel": [], "gel_around": [*AROUND, "substrate.viscosity=0"], "gel_explicit": [*AROUND, *EXPLICIT]}.items():
    for strain in ("small", "finite"):
        for count in (1, 3):
            run(count, "tensotaxis_pull_2d", f"{name}_{strain}_{count}", [*SLOW, f"substrate.strain={strain}", *settings])
        check_same(f"{name}, strain = {strain}, 3 processes", f"{name}_{strain}_3", f"{name}_{strain}_1")
SPACE = ["domain.elements=[20,20,14]", "time.end=0.02", "output.fields.times=[]", "substrate.fibre.azimuth=20",
         "substrate.gravity=[0.01,0,-0.02]", *(s for s in SCENE if s.startswith(("fluid.w", "fluid.contact", "substrate.s", "substrate.v",
                                                                                  "substrate.f", "substrate.y", "boundary")))]
for count in (1, 2):
    run(count, "static_droplet_soft_3d", f"space_{count}", SPACE)
check_same("space, 2 processes", "space_2", "space_1")
