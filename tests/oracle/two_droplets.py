#!/usr/bin/env python3
"""Force between two droplets on an elastic layer (inverted Cheerios), in linear elasticity and plane strain.

The droplet lies at X beside a mirror at x = 0, on a clamped layer in a box [0, L] whose other side is a mirror too. It
loads the layer by its contact lines, sigma sin(alpha) K each, and its pressure sigma/R, as in ridge_locking.py; K has
the width of the interface. The layer has the compliance of axial_ridge.py and the surface tension Y, so that with t_n,
the waves cos(k_n x) of the load,
    u_n = t_n / (1/C(k_n) + Y k_n^2). The energy of the layer under its load is -1/2 int t u dx. Its change as the
    droplet moves with its load is the force on it along the wall, F = int t du/dx dx; where it is positive the two
    repel each other. The pull along the wall, sigma cos(alpha), is left out: alpha is near 90 degrees. Prints the force
    over sigma. No code of softwet."""

import argparse

import numpy
from axial_ridge import compliance
from ridge_locking import interface, tractions


def force(place, height, young, poisson, tension, capillarity, radius, angle, length):
    """Force on the droplet over the tension of the liquid. @param tension  of the solid, over the liquid's; angle in
    radians"""
    count = int(48 * length / capillarity)
    x = (numpy.arange(count) + 0.5) * length / count
    load = tractions(x, capillarity, radius, angle, place)[1]
    liquid = interface()[0].tension * capillarity
    k = numpy.arange(1, int(3 * length / capillarity)) * numpy.pi / length
    waves = numpy.cos(numpy.outer(k, x)) @ load * 2 / count
    height_of = waves / (1 / compliance(k, poisson, height=height, young=young) + tension * liquid * k**2)
    slope = -(height_of * k) @ numpy.sin(numpy.outer(k, x))
    return (load @ slope) * length / count / liquid


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--heights", type=float, nargs="+", default=[0.0625, 0.125, 0.375])
    parser.add_argument("places", type=float, nargs="*", default=[0.1875, 0.21875, 0.25, 0.3125, 0.375])
    arguments = parser.parse_args()
    for height in arguments.heights:
        forces = [force(place, height, 0.4, 0.49, 1, 1 / 64, 0.11, numpy.pi / 2, 0.75) for place in arguments.places]
        print(f"H {height}: " + ", ".join(f"{value:+.6f} at {place}" for place, value in zip(arguments.places, forces)))
