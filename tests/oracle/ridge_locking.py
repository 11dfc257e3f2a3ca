#!/usr/bin/env python3
"""How much too low a coarse mesh of splines makes the ridge under a contact line, for nearly incompressible layers.

A droplet at rest on the layer [0, L] x [0, H] (rollers below and at the sides, linear elasticity, plane strain) loads
its top. A contact line at x_0 under the angle alpha pulls with sigma t K(x), t along the interface, where the planar
interface has K = 2 D(rho) sin(alpha)/sigma at the distance (x - x_0) sin(alpha) from its middle density; inside, the
pressure sigma/R pushes down. The same layer in splines of degree 5 on a mesh twice as fine is the reference: its ridge
is 5.8136e-3, 5.5552e-3, 5.4943e-3 and 5.4881e-3 for nu = 0.45, 0.49, 0.499, 0.4999 at a capillarity of 1/64, as the
ridge of a series in cosines with the exact compliance of a layer. Prints the rows of
tests/unit/scene/test_forecast.cpp. No code of softwet."""

import sys

import numpy
import scipy.sparse as sparse
from plane_interface import PlaneInterface
from scipy.interpolate import BSpline
from scipy.sparse.linalg import spsolve

LENGTH, HEIGHT, YOUNG, RADIUS, ANGLE = 1.0, 0.125, 0.7554, 0.155, numpy.radians(75)


class Splines:
    """Splines of one axis with as many continuous derivatives as their degree allows."""

    def __init__(self, length, elements, degree):
        breaks = numpy.linspace(0, length, elements + 1)
        self.knots = numpy.concatenate(([0.0] * degree, breaks, [length] * degree))
        self.length, self.degree, self.count = length, degree, elements + degree
        s, w = numpy.polynomial.legendre.leggauss(12)
        self.points = (0.5 * (breaks[:-1, None] + breaks[1:, None]) + 0.5 * length / elements * s).ravel()
        self.weights = numpy.tile(0.5 * length / elements * w, elements)

    def at(self, x, derivative=0):
        if derivative:
            spline = BSpline(self.knots, numpy.eye(self.count), self.degree).derivative()
            return sparse.csr_matrix(spline(x))
        return BSpline.design_matrix(numpy.minimum(x, self.length * (1 - 1e-15)), self.knots, self.degree)

    def matrix(self, a, b):
        """int N_i^(a) N_j^(b)"""
        return self.at(self.points, a).T @ sparse.diags(self.weights) @ self.at(self.points, b)

    def vector(self, values):
        return self.at(self.points).T @ (self.weights * values)


def interface(theta=0.39, panels=4000):
    """Distance from the middle density over g, density and 2 D of the planar interface; liquid at positive
    distances."""
    plane = PlaneInterface(theta)
    z = numpy.linspace(-16, 16, panels + 1)  # rho = rho_v + (rho_l - rho_v) / (1 + exp(-z))
    part = 1 / (1 + numpy.exp(-z))
    rho = plane.vapour + plane.step * part
    root = numpy.sqrt(2 * plane.excess(rho))
    rate = plane.step * part * (1 - part) / numpy.maximum(root, 1e-300)
    distance = numpy.concatenate(([0], numpy.cumsum(0.5 * (rate[1:] + rate[:-1]) * numpy.diff(z))))
    return plane, distance - numpy.interp(0, z, distance), rho, root**2


def tractions(x, capillarity, radius=RADIUS, angle=ANGLE, middle=0.5 * LENGTH):
    """t_x, t_y at places of the wall under a droplet in the middle."""
    plane, distance, rho, twice_excess = interface()
    tension, cut = plane.tension * capillarity, numpy.sin(angle) / capillarity
    foot = radius * numpy.sin(angle)
    left, right = (x - middle + foot) * cut, (middle + foot - x) * cut
    kernel = [numpy.interp(s, distance, twice_excess, 0, 0) * cut / plane.tension for s in (left, right)]
    inside = [(numpy.interp(s, distance, rho) - plane.vapour) / plane.step for s in (left, right)]
    return (tension * numpy.cos(angle) * (kernel[0] - kernel[1]),
            tension * numpy.sin(angle) * (kernel[0] + kernel[1]) - tension / radius * (inside[0] + inside[1] - 1))


def highest_point(x, y, stiffness, capillarity):
    """Largest vertical displacement of the top of a layer with this stiffness under the droplet."""
    top = numpy.zeros(y.count)
    top[-1] = 1
    load = numpy.concatenate([numpy.kron(x.vector(t), top) for t in tractions(x.points, capillarity)])
    number = numpy.arange(x.count * y.count).reshape(x.count, y.count)
    free = numpy.ones(2 * number.size, bool)
    free[numpy.concatenate((number[0], number[-1], number.size + number[:, 0]))] = False
    stiffness = stiffness.tocsr()
    u = numpy.zeros(2 * number.size)
    u[free] = spsolve(stiffness[free][:, free].tocsc(), load[free])
    surface = u[number.size:].reshape(number.shape)[:, -1]
    return (x.at(numpy.linspace(0, LENGTH / 2, 2001)) @ surface).max()


def ridge(elements, rows, degree, poisson, capillarity):
    """Largest vertical displacement of the top."""
    first, shear = YOUNG * poisson / ((1 + poisson) * (1 - 2 * poisson)), YOUNG / (2 * (1 + poisson))
    x, y = Splines(LENGTH, elements, degree), Splines(HEIGHT, rows, degree)
    (mx, bx, kx), (my, by, ky) = (tuple(axis.matrix(*ab) for ab in ((0, 0), (0, 1), (1, 1))) for axis in (x, y))
    xx = (first + 2 * shear) * sparse.kron(kx, my) + shear * sparse.kron(mx, ky)
    yy = (first + 2 * shear) * sparse.kron(mx, ky) + shear * sparse.kron(kx, my)
    xy = first * sparse.kron(bx.T, by) + shear * sparse.kron(bx, by.T)
    return highest_point(x, y, sparse.bmat([[xx, xy], [xy.T, yy]]), capillarity)


if __name__ == "__main__":
    poissons = [float(nu) for nu in sys.argv[1:]] or [0.45, 0.49, 0.499, 0.4999]
    for elements, rows in ((64, 8), (128, 16)):
        for width in (1.5, 2, 3, 4):  # of the capillarity, in elements
            for nu in poissons:
                g = width / elements
                exact = ridge(2 * elements, 2 * rows, 5, nu, g)
                errors = [100 * (ridge(elements, rows, degree, nu, g) / exact - 1) for degree in (2, 3)]
                print(f"{elements} x {rows}, capillarity {width} h, nu {nu}: ridge {exact:.4e}, errors "
                      f"{errors[0]:+.3f} % with degree 2, {errors[1]:+.3f} % with degree 3", flush=True)
