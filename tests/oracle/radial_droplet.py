#!/usr/bin/env python3
"""Droplet at rest in a disc or ball: density at its centre, in the vapour, and the pressure jump between the two.

Solves mu = W'(rho) - g^2 (rho'' + (d - 1)/r rho') with rho' = 0 at both ends and a given mass, by Chebyshev collocation
and Newton's method in ln(rho/(1 - rho)). No code or method shared with softwet. Run by hand it prints the three cases
of radius 0.5 whose values are known from another solver, and how they change with the number of points."""

import numpy

POINTS = 320
A = 8 / 27


def energy_slope(theta, rho):
    """W'(rho)"""
    return A * theta * (numpy.log(rho / (1 - rho)) + 1 / (1 - rho)) - 2 * rho


def energy_curvature(theta, rho):
    """W''(rho)"""
    return A * theta / (rho * (1 - rho) ** 2) - 2


def pressure(theta, rho):
    return A * theta * rho / (1 - rho) - rho * rho


def coexistence(theta):
    """Vapour and liquid densities of a plane interface."""
    vapour, liquid = {0.39: (1e-3, 0.87), 0.5: (7e-3, 0.82), 0.7: (0.04, 0.71), 0.85: (0.1, 0.6), 0.95: (0.19, 0.49)}[theta]
    for _ in range(100):
        f = numpy.array([pressure(theta, vapour) - pressure(theta, liquid),
                         energy_slope(theta, vapour) - energy_slope(theta, liquid)])
        cv, cl = energy_curvature(theta, vapour), energy_curvature(theta, liquid)
        step = numpy.linalg.solve([[vapour * cv * vapour, -liquid * cl], [cv * vapour, -cl]], -f)
        vapour, liquid = vapour * numpy.exp(step[0]), liquid + step[1]
    return vapour, liquid


def chebyshev(points, length):
    """Points on [0, length], matrix of the first derivative, weights of the integral."""
    n = points - 1
    x = numpy.cos(numpy.pi * numpy.arange(points) / n)
    c = numpy.where((numpy.arange(points) % n) == 0, 2.0, 1.0) * (-1.0) ** numpy.arange(points)
    d = numpy.outer(c, 1 / c) / (x[:, None] - x[None, :] + numpy.eye(points))
    d -= numpy.diag(d.sum(axis=1))
    weight = numpy.zeros(points)  # Clenshaw-Curtis
    for j in range(points):
        k = numpy.arange(1, n // 2 + 1)
        b = numpy.where(2 * k == n, 1.0, 2.0)
        weight[j] = (1 - (b * numpy.cos(2 * k * j * numpy.pi / n) / (4 * k * k - 1)).sum()) * 2 / n
    weight[[0, -1]] /= 2
    return 0.5 * length * (1 - x), -2 / length * d, 0.5 * length * weight


def solve(capillarity, mass, theta=0.39, dimension=2, length=0.5, volume=None, points=POINTS,
          profile=False):
    """@param volume  of the container if it is no disc or ball: the rest beyond `length` holds the outer density
    @param profile  return the densities at all Chebyshev points instead
    @return densities at the centre and at `length`, chemical potential, radius of the middle density"""
    vapour, liquid = coexistence(theta)
    r, d, weight = chebyshev(points, length)
    shell = weight * (2 * numpy.pi * r if dimension == 2 else 4 * numpy.pi * r * r)
    rest = 0.0 if volume is None else volume - shell.sum()
    lap = d @ d
    lap[1:] += ((dimension - 1) / r[1:])[:, None] * d[1:]
    constant = numpy.pi if dimension == 2 else 4 / 3 * numpy.pi
    radius = ((mass - vapour * (shell.sum() + rest)) / (constant * (liquid - vapour))) ** (1 / dimension)
    rho = vapour + (liquid - vapour) * 0.5 * (1 - numpy.tanh((r - radius) / capillarity))
    rho[rho < 1.2 * vapour] = 1.2 * vapour
    z = numpy.log(rho / (1 - rho))
    mu = energy_slope(theta, liquid)
    for _ in range(200):
        rho = 1 / (1 + numpy.exp(-z))
        slope = rho * (1 - rho)  # d rho / d z
        f = numpy.append(energy_slope(theta, rho) - capillarity**2 * (lap @ rho) - mu,
                         shell @ rho + rest * rho[-1] - mass)
        j = numpy.zeros((points + 1, points + 1))
        j[:-1, :-1] = (numpy.diag(energy_curvature(theta, rho)) - capillarity**2 * lap) * slope
        j[:-1, -1] = -1
        j[-1, :-1] = shell * slope
        j[-1, -2] += rest * slope[-1]
        for end in (0, -2):  # no flux through the ends
            f[end] = d[0 if end == 0 else -1] @ rho
            j[end, :] = 0
            j[end, :-1] = d[0 if end == 0 else -1] * slope
        step = numpy.linalg.solve(j, -f)
        damping = min(1.0, 1.0 / numpy.abs(step[:-1]).max())
        z, mu = z + damping * step[:-1], mu + damping * step[-1]
        if numpy.abs(step).max() < 1e-11:
            break
    else:
        raise ArithmeticError("radial droplet: Newton's method did not converge")
    rho = 1 / (1 + numpy.exp(-z))
    if profile:
        return rho
    i = numpy.nonzero(rho > 0.5 * (vapour + liquid))[0].max()
    middle = r[i] + (r[i + 1] - r[i]) * (rho[i] - 0.5 * (vapour + liquid)) / (rho[i] - rho[i + 1])
    return rho[0], rho[-1], mu, middle


def sharp_mass(radius, theta=0.39, dimension=2, length=0.5):
    vapour, liquid = coexistence(theta)
    constant = numpy.pi if dimension == 2 else 4 / 3 * numpy.pi
    return constant * (liquid * radius**dimension + vapour * (length**dimension - radius**dimension))


if __name__ == "__main__":
    known = {(2, 0.10): (0.87454040, 0.00204483, 0.04044886), (2, 0.15): (0.87199616, 0.00177476, 0.02661551),
             (3, 0.15): (0.87694492, 0.00235407, 0.05420046)}
    for (dimension, radius), values in known.items():
        print(f"{dimension}D, sharp radius {radius}: known    {values[0]:.8f} {values[1]:.8f} {values[2]:.8f}")
        for points in (160, 240, 320, 400):
            inside, outside, mu, middle = solve(1 / 64, sharp_mass(radius, dimension=dimension), dimension=dimension,
                                                points=points)
            jump = pressure(0.39, inside) - pressure(0.39, outside)
            print(f"   {points} points: {inside:.8f} {outside:.8f} {jump:.8f}   mu {mu:.8f}  radius {middle:.6f}")
