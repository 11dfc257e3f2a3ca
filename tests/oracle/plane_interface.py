#!/usr/bin/env python3
"""The plane interface of the van der Waals fluid: bulk states, surface tension, width. Only numpy; no code of softwet.

First integral of mu_sat = W'(rho) - g^2 rho'':  g^2 rho'^2 / 2 = D(rho) := W(rho) - mu_sat rho + p_sat, hence
    sigma = int (W + g^2 rho'^2/2 - mu_sat rho + p_sat) dx = g int_{rho_v}^{rho_l} sqrt(2 D) d rho,
    width between two densities = g int d rho / sqrt(2 D)."""

import numpy
from radial_droplet import A, coexistence, energy_curvature, energy_slope, pressure


def energy(theta, rho):
    """W(rho)"""
    return A * theta * rho * numpy.log(rho / (1 - rho)) - rho * rho


class PlaneInterface:
    """vapour, liquid (densities), potential (mu_sat), pressure (p_sat), tension (sigma/g), width (10-90 %, over g)"""

    def __init__(self, theta):
        self.theta = theta
        self.vapour, self.liquid = coexistence(theta)
        self.potential = energy_slope(theta, self.liquid)
        self.pressure = pressure(theta, self.liquid)
        self.step = self.liquid - self.vapour
        self.tension = self.integral(lambda rho: numpy.sqrt(2 * self.excess(rho)), 0, 1)
        self.width = self.integral(lambda rho: 1 / numpy.sqrt(2 * self.excess(rho)), 0.1, 0.9)

    def excess(self, rho):
        """D(rho); rounding may not make it negative."""
        return numpy.maximum(energy(self.theta, rho) - self.potential * rho + self.pressure, 0)

    def integral(self, f, low, high, points=400):
        """int f d rho between two parts of the step, Gauss-Legendre in s with the part s^2:
        sqrt(2 D) bends near the vapour."""
        s, weight = numpy.polynomial.legendre.leggauss(points)
        a, b = numpy.sqrt(low), numpy.sqrt(high)
        s, weight = 0.5 * (a + b) + 0.5 * (b - a) * s, 0.5 * (b - a) * weight
        return (weight * 2 * s * self.step * f(self.vapour + self.step * s * s)).sum()

    def sound_speed(self, rho):
        return numpy.sqrt(rho * energy_curvature(self.theta, rho))


if __name__ == "__main__":
    for theta in (0.39, 0.5, 0.7, 0.85, 0.95):
        plane = PlaneInterface(theta)
        print(theta, *(f"{value:.10g}" for value in (plane.vapour, plane.liquid, plane.pressure, plane.potential,
              plane.sound_speed(plane.liquid), plane.sound_speed(plane.vapour), plane.tension, plane.width)))
