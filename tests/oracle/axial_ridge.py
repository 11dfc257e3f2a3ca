#!/usr/bin/env python3
"""Wall under a sessile droplet with an axis of symmetry, in linear elasticity: the case style_2013_axisymmetric. With
--sharp the wall below a half ball of liquid with an interface of zero width, at the wall's one tension.

A layer of height H on a clamped bottom fills a cylinder of radius L with a side on which it slips. Its top has the
surface tension Y(r): wet below the droplet, dry outside. The contact line at r_c pulls upwards with sigma sin(alpha)
K(r), where the plane interface has K = 2 D(rho) sin(alpha)/sigma at the distance (r - r_c) sin(alpha) from its middle
density; the pressure 2 sigma/R pushes down inside. The wall energy acts on the wall as a tension, so that the pull
along the wall is zero. With the functions J_0(k_n r), J_1(k_n L) = 0, and the compliance C(k) of the layer,
    sum_m [ delta_nm |J_0|^2 / C(k_n) + int Y k_n k_m J_1 J_1 r dr ] u_m = int t J_0(k_n r) r dr.
A surface modulus M = lambda_s + 2 G_s adds M k^2 to the stiffness of the layer along the wall, where nothing pulls:
    C = C_zz - C_rz^2 M k^2 / (1 + M k^2 C_rr). Prints heights in micrometres for the widths g (in micrometres) and the
    Poisson ratios that are given. No code of softwet."""

import argparse

import numpy
from ridge_locking import interface
from scipy.special import j0, j1, jn_zeros

SIDE, HEIGHT, YOUNG, RADIUS = 500.0, 50.0, 3.0, 178.4  # micrometres, kPa
LIQUID, WET, DRY = 46.0, 36.0, 31.0                    # mN/m


def compliance(k, poisson, modulus=0.0, height=HEIGHT, young=YOUNG):
    """Displacement upwards over a normal load in one wave: a layer that is clamped at its bottom, with a surface
    modulus."""
    z, q = k * height, 3 - 4 * poisson
    small = numpy.exp(-2 * z)  # all is divided by exp(2 z)/2
    below = q * (1 + small**2) + 2 * (2 * z**2 + 5 - 12 * poisson + 8 * poisson**2) * small
    upright = 2 * (1 - poisson**2) / (young * k) * (q * (1 - small**2) - 4 * z * small) / below
    along = 2 * (1 - poisson**2) / (young * k) * (q * (1 - small**2) + 4 * z * small) / below
    cross = (1 + poisson) / (young * k) * ((1 - 2 * poisson) * q * (1 - small)**2 - 4 * z**2 * small) / below
    return upright - cross**2 * modulus * k**2 / (1 + modulus * k**2 * along)


def wall(g, poisson, stiffer=1.0, radius=RADIUS, modulus=0.0):
    """r, r_c, height and slope of the wall, times stiffer: the factor of the modulus and of the dry tension. The liquid
    stays as it is, so that the wet tension differs from the dry one by as much as without the factor."""
    angle = numpy.arccos((DRY - WET) / LIQUID)
    foot, cut = radius * numpy.sin(angle), numpy.sin(angle) / g
    count = int(12 * SIDE / g)
    r = (numpy.arange(count) + 0.5) * SIDE / count
    weight = r * SIDE / count
    plane, distance, rho, twice_excess = interface()
    kernel = numpy.interp((foot - r) * cut, distance, twice_excess, 0, 0)
    kernel *= foot / (kernel @ weight)
    inside = (numpy.interp((foot - r) * cut, distance, rho) - plane.vapour) / plane.step
    pressure = inside * 0.5 * foot**2 / (inside @ weight)  # both have the total force of a sharp line
    load = LIQUID * numpy.sin(angle) * kernel - 2 * LIQUID / radius * pressure
    k = jn_zeros(1, int(3 * SIDE / g)) / SIDE
    waves, slopes = j0(numpy.outer(k, r)), k[:, None] * j1(numpy.outer(k, r))
    norm = 0.5 * SIDE**2 * j0(k * SIDE)**2
    tension = DRY + (WET - DRY) / stiffer * inside
    stiffness = numpy.diag(norm / compliance(k, poisson, modulus)) + (slopes * (tension * weight)) @ slopes.T
    amplitude = numpy.linalg.solve(stiffness, waves @ (load * weight))
    return r, foot, amplitude @ waves, -amplitude @ slopes


def sharp(foot, height, young, tension, side, liquid, poisson, count=100000):
    """Heights of the wall at the line and in the middle for an interface of zero width, the angle of 90 degrees and a
    wall of one tension: the load is a line and an even pressure, and each wave is by itself."""
    k = jn_zeros(1, count) / side
    load = liquid * foot * j0(k * foot) - 2 * liquid / foot * foot * j1(k * foot) / k
    stiffness = 0.5 * side**2 * j0(k * side)**2 * (1 / compliance(k, poisson, 0.0, height, young) + tension * k**2)
    return (load / stiffness) @ j0(k * foot), (load / stiffness).sum()


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--poisson", type=float, nargs="+", default=[0.49])
    parser.add_argument("--stiffer", type=float, default=1, help="factor of modulus and dry tension; heights are times that")
    parser.add_argument("--radius", type=float, default=RADIUS, help="of the droplet, micrometres")
    parser.add_argument("--modulus", type=float, default=0, help="of the surface, mN/m")
    parser.add_argument("--sharp", type=float, nargs=6, metavar=("R", "H", "E", "Y", "L", "SIGMA"),
                        help="zero width, 90 degrees: radius, thickness, modulus, tensions of the wall, side, and liquid")
    parser.add_argument("widths", type=float, nargs="*", default=[10, 5, 2.5])
    arguments = parser.parse_args()
    if arguments.sharp:
        radius, thickness, young, tension, side, liquid = arguments.sharp
        for poisson in arguments.poisson:
            print("nu %g, zero width: ridge %.4f um, middle %.5f um" %
                  (poisson, *sharp(radius, thickness, young, tension, side, liquid, poisson)))
        raise SystemExit
    for poisson in arguments.poisson:
        for g in arguments.widths:
            r, foot, height, slope = wall(g, poisson, arguments.stiffer, arguments.radius, arguments.modulus)
            ridge = height.argmax()
            opening = 180 - numpy.degrees(numpy.arctan(slope.max()) - numpy.arctan(slope.min()))
            print(f"nu {poisson}, g {g} um: ridge {height[ridge]:.3f} um at r_c {r[ridge] - foot:+.2f} um, middle {height[0]:.3f}, "
                  f"outside {height[r > foot + 10].min():.3f}, slopes {slope.max():+.3f} {slope.min():+.3f}, opening {opening:.1f} degrees",
                  flush=True)
