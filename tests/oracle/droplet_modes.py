#!/usr/bin/env python3
"""Small oscillations of a droplet in a disc: eigenvalues of the linearised Navier-Stokes-Korteweg equations, mode n.

About a droplet at rest rho_0(r), mu_0 constant, with (rho, u_r, u_theta) = (R, U, i V)(r) exp(i n theta + s t) and
' = d/dr, L f = f'' + f'/r - n^2 f/r^2, div = U' + U/r - n V/r, m the viscosity, g the capillarity:

    s R       = - (r rho_0 U)'/r + n rho_0 V/r                    mass
    mu        = W''(rho_0) R - g^2 L R                            chemical potential
    s rho_0 U = - rho_0 mu' + m (L U - U/r^2 + 2 n V/r^2) + (m/3) div'
    s rho_0 V = - n rho_0 mu/r + m (L V - V/r^2 + 2 n U/r^2) + (m/3) n div/r

from div(m (grad v + grad v^T) - (2/3) m div v I) = m Lap v + (m/3) grad div v. All vanish at r = 0 (n = 2 and more);
at the rim R' = U = 0 and no shear, V' - V/r + n U/r = 0. Chebyshev collocation; nothing is sharp, inviscid or
incompressible here, so Lamb's formula for a sharp incompressible droplet differs by all of that. No code of softwet."""

import numpy
import radial_droplet
from plane_interface import PlaneInterface


def equilibrium(capillarity, theta, mass, length, points):
    """rho_0 at the Chebyshev points."""
    return radial_droplet.solve(capillarity, mass, theta=theta, length=length, points=points, profile=True)


def spectrum(capillarity, viscosity, theta, rho, length, n=2):
    """@param rho  droplet at rest at the Chebyshev points;  @return all eigenvalues s"""
    points, g, m = len(rho), capillarity, viscosity
    r, d, _ = radial_droplet.chebyshev(points, length)
    inner = r[1:, None]  # without the centre, where all is 0
    d1, d2 = d[1:, 1:], (d @ d)[1:, 1:]
    rho, unit, zero = rho[1:, None], numpy.eye(points - 1), numpy.zeros((points - 1, points - 1))
    lap = d2 + d1 / inner - n * n * unit / inner**2
    last = -1
    # Values of R, U, V at the rim follow from the conditions there: columns of the rim are eliminated.
    divergence = {"U": d1 + unit / inner, "V": -n * unit / inner}
    potential = radial_droplet.energy_curvature(theta, rho) * unit - g * g * lap
    block = {
        ("R", "U"): -(d1 @ (inner * rho * unit)) / inner, ("R", "V"): n * rho * unit / inner,
        ("U", "R"): -d1 @ potential, ("V", "R"): -n * potential / inner,
        ("U", "U"): m * (lap - unit / inner**2) + m / 3 * d1 @ divergence["U"],
        ("U", "V"): m * 2 * n * unit / inner**2 + m / 3 * d1 @ divergence["V"],
        ("V", "V"): m * (lap - unit / inner**2) + m / 3 * n * divergence["V"] / inner,
        ("V", "U"): m * 2 * n * unit / inner**2 + m / 3 * n * divergence["U"] / inner}
    for row in "UV":
        for column in "UV":
            block[row, column] = block[row, column] / rho
    free = slice(0, points - 2)
    rows = []
    # R(rim) = - sum d1[rim, j] R_j / d1[rim, rim];  V(rim) likewise with d1 - 1/r (U(rim) = 0).
    extend = {"U": unit[:, free].copy()}
    for name, row in (("R", d1[last]), ("V", d1[last] - unit[last] / r[last])):
        extend[name] = unit[:, free].copy()
        extend[name][last] = -row[free] / row[last]
    for row in "RUV":
        rows.append([(block.get((row, column), zero) @ extend[column])[free] for column in "RUV"])
    return numpy.linalg.eigvals(numpy.block(rows))


def oscillation(capillarity, viscosity, theta, mass, length, guess, n=2, points=200):
    """Eigenvalue nearest to the guess: s = - damping +- i frequency."""
    rho = equilibrium(capillarity, theta, mass, length, points)
    s = spectrum(capillarity, viscosity, theta, rho, length, n)
    return s[numpy.argmin(numpy.abs(s - guess))]


def sharp(capillarity, viscosity, theta, radius, n=2):
    """Lamb: frequency of an inviscid sharp droplet in its vapour, omega^2 = n (n^2 - 1) sigma/((rho_l + rho_v) R^3),
    and damping 2 n (n - 1) nu/R^2 in two dimensions."""
    plane = PlaneInterface(theta)
    square = n * (n * n - 1) * plane.tension * capillarity / ((plane.liquid + plane.vapour) * radius**3)
    return -2 * n * (n - 1) * viscosity / plane.liquid / radius**2 + 1j * numpy.sqrt(square)


if __name__ == "__main__":
    for g, radius, m in ((1 / 64, 0.2, 3e-4), (1 / 128, 0.2, 3e-4), (1 / 64, 0.2, 1e-3)):
        mass = radial_droplet.sharp_mass(radius)
        lamb = sharp(g, m, 0.39, radius)
        for points in (160, 200, 260):
            print(g, radius, m, points, lamb, oscillation(g, m, 0.39, mass, 0.5, lamb, points=points), flush=True)
