#!/usr/bin/env python3
"""Coexistence, sound speeds and surface tension of the van der Waals fluid, in 40-digit decimals.

Prints the rows of tests/unit/scene/test_equilibrium.cpp. No code or method shared with softwet: Newton's method on both
densities at once from the equation of state, and tanh-sinh quadrature of sqrt(2 D)."""
from decimal import Decimal as N, getcontext

getcontext().prec = 40
A = N(8) / N(27)


def pressure(th, r):
    return A * th * r / (1 - r) - r * r


def potential(th, r):
    return A * th * ((r / (1 - r)).ln() + 1 / (1 - r)) - 2 * r


def slope(th, r):
    """p'(r) = r mu'(r)"""
    return A * th / (1 - r) ** 2 - 2 * r


def coexistence(th, v, l):
    """p(v) = p(l), mu(v) = mu(l); unknowns ln(v) and l."""
    for _ in range(60):
        f, g = pressure(th, v) - pressure(th, l), potential(th, v) - potential(th, l)
        a, b, c, d = slope(th, v) * v, -slope(th, l), slope(th, v), -slope(th, l) / l
        det = a * d - b * c
        s, t = (f * d - b * g) / det, (a * g - c * f) / det
        v, l = v * (-s).exp(), l - t
    return v, l


def tension(th, v, l):
    mu, p = potential(th, v), pressure(th, v)
    half_pi, h, total = N("1.570796326794896619231321691639751442099"), N(1) / 32, N(0)
    for k in range(-130, 131):
        u = half_pi * ((k * h).exp() - (-k * h).exp()) / 2
        weight = half_pi * ((k * h).exp() + (-k * h).exp()) / 2 / ((u.exp() + (-u).exp()) / 2) ** 2
        r = (v + l) / 2 + (l - v) / 2 * (u.exp() - (-u).exp()) / (u.exp() + (-u).exp())
        if not v < r < l:
            continue
        excess = A * th * r * (r / (1 - r)).ln() - r * r - mu * r + p
        total += weight * (2 * max(excess, N(0))).sqrt()
    return total * h * (l - v) / 2


SCENES = (("0.39", "0.0013", "0.867"), ("0.5", "0.007", "0.82"), ("0.7", "0.043", "0.713"), ("0.85", "0.107", "0.602"),
          ("0.95", "0.193", "0.487"))  # temperature, and densities to start from

if __name__ == "__main__":
    for theta, v, l in SCENES:
        th = N(theta)
        v, l = coexistence(th, N(v), N(l))
        row = (th, v, l, pressure(th, v), potential(th, v), slope(th, l).sqrt(), slope(th, v).sqrt(), tension(th, v, l))
        print("{" + ", ".join(f"{float(x):.10g}" for x in row) + "},")
