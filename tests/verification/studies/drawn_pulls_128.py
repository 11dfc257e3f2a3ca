"""Pulled droplets of scenes drawn at random, on the mesh of Fig. 2: path and peak speed against fine steps.

The first four scenes of [drawn_pulls](drawn_pulls.md) on 128 x 64 elements, with the capillarity of Fig. 2: a droplet is carried over twice as
many widths of its interface as there, and the same bounds are asked for. What is drawn, and how it is measured, is told there."""

from _drawn import compare

MINUTES = {"quick": 1.3, "full": 25}
SHORT = ("scene 103 goes 0.0034 in all, less than half of an element, and is off by 7e-5; with time.tolerance = 5e-4 it is as far off, so "
         "that this is no error of long steps")
STEPS = "a short peak of the speed lies within one or two steps of a draft"
MESH = "the mesh, as on 64 x 32 elements"
EXPLICIT = "takes hundreds of units of time at the temperature 0.39: millions of explicit steps"


def study(lab):
    compare(lab, 128, 0 if lab.quick else 4, {
        "standard": (SHORT, 2.5, 3), "draft on its own mesh": (STEPS, 4, 30), "draft": (MESH, 60, 40)})
