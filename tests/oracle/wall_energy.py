#!/usr/bin/env python3
"""Excess of the free energy, its slope, and the integral of the smoothed root, in 40-digit decimals.

Prints the rows of tests/unit/fluid/test_wall_energy.cpp: densities between and beyond the phases, and below the density
where W is continued by a parabola. No code or method shared with softwet: D is the plain difference W - mu rho + p, and
the integral of sqrt(2 D + d^2) - d is tanh-sinh quadrature between all densities where the root bends."""
from decimal import Decimal as N

from equilibrium import A, SCENES, coexistence, potential, pressure


class Fluid:
    def __init__(self, theta, vapour, liquid):
        self.theta = N(theta)
        self.vapour, self.liquid = coexistence(self.theta, N(vapour), N(liquid))
        self.potential, self.pressure = potential(self.theta, self.vapour), pressure(self.theta, self.vapour)
        self.continuation = self.vapour / 5

    def excess(self, r):
        """D(r)"""
        low = self.continuation
        if r < low:
            return self.excess(low) + (r - low) * (self.slope(low) + self.slope(r)) / 2
        return A * self.theta * r * (r / (1 - r)).ln() - r * r - self.potential * r + self.pressure

    def slope(self, r):
        """D'(r)"""
        low = self.continuation
        if r < low:
            return self.slope(low) + (A * self.theta / (low * (1 - low) ** 2) - 2) * (r - low)
        return potential(self.theta, r) - self.potential

    def integral(self, to, d):
        """of sqrt(2 D + d^2) - d from the vapour"""
        low, high = min(self.vapour, to), max(self.vapour, to)
        bends = [r for r in (self.continuation, self.liquid) if low < r < high]
        ends = sorted([self.vapour, to] + bends)
        total = sum(tanh_sinh(lambda r: (2 * max(self.excess(r), 0) + d * d).sqrt() - d, a, b)
                    for a, b in zip(ends, ends[1:]))
        return total if to > self.vapour else -total


def tanh_sinh(f, a, b):
    half_pi, h, total = N("1.570796326794896619231321691639751442099"), N(1) / 32, N(0)
    for k in range(-130, 131):
        u = half_pi * ((k * h).exp() - (-k * h).exp()) / 2
        weight = half_pi * ((k * h).exp() + (-k * h).exp()) / 2 / ((u.exp() + (-u).exp()) / 2) ** 2
        r = (a + b) / 2 + (b - a) / 2 * (u.exp() - (-u).exp()) / (u.exp() + (-u).exp())
        if a < r < b:
            total += weight * f(r)
    return total * h * (b - a) / 2


if __name__ == "__main__":
    for scene in SCENES[::2]:
        fluid = Fluid(*scene)
        constants = (fluid.theta, fluid.vapour, fluid.liquid, fluid.pressure, fluid.potential)
        print("theta, densities, pressure, potential: " + ", ".join(f"{float(x):.17g}" for x in constants))
        v, l = fluid.vapour, fluid.liquid
        for part in ("-0.1", "-0.0001", "0.0001", "0.1", "0.4999", "0.5001", "0.9", "0.9999", "1.0001", "1.02", "1.1"):
            rho = N(float(v + N(part) * (l - v)))
            row = (rho, fluid.excess(rho), fluid.slope(rho), fluid.integral(rho, N("1e-5")), fluid.integral(rho, N("1e-3")))
            print("{" + ", ".join(f"{float(x):.17g}" for x in row) + "},")
