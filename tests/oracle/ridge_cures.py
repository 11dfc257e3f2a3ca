#!/usr/bin/env python3
"""Ways to keep a nearly incompressible layer from locking under a contact line, on the scene of ridge_locking.py.

full: the first Lame parameter at all points. means CAP: CAP shear moduli of it at all points, the rest for the means
over elements. points CAP N: the rest at N points along each axis of an element. pressure: a further field of splines of
degree 2, with 0.001 h^2/(2 G) (Grad q, Grad p). Prints errors of the ridge in per cent, and the rows of docs/limits.md.
No code of softwet."""

import numpy
import scipy.sparse as sparse
from ridge_locking import HEIGHT, LENGTH, YOUNG, Splines, highest_point
from scipy.sparse.linalg import spsolve


class RuledSplines(Splines):
    """With any number of Gauss points on an element."""

    def pairs(self, a, b, points):
        """int N_i^(a) N_j^(b)"""
        elements = self.count - self.degree
        breaks = numpy.linspace(0, self.length, elements + 1)
        s, w = numpy.polynomial.legendre.leggauss(points)
        half = 0.5 * self.length / elements
        x = (0.5 * (breaks[:-1, None] + breaks[1:, None]) + half * s).ravel()
        return self.at(x, a).T @ sparse.diags(numpy.tile(half * w, elements)) @ self.at(x, b)

    def means(self, derivative):
        """Means of N_i or of its slope over each element, shape (elements, count)."""
        elements = self.count - self.degree
        x, w = numpy.polynomial.legendre.leggauss(6)
        h = self.length / elements
        points = (numpy.arange(elements)[:, None] + 0.5 + 0.5 * x).ravel() * h
        sums = sparse.kron(sparse.eye(elements), 0.5 * w)
        return sums @ self.at(points, derivative)

    def all_pairs(self, points):
        """Products of values, of values and slopes, of slopes: at Gauss points, or of means where points is 0."""
        orders = ((0, 0), (0, 1), (1, 1))
        if points:
            return [self.pairs(a, b, points) for a, b in orders]
        h = self.length / (self.count - self.degree)
        return [h * self.means(a).T @ self.means(b) for a, b in orders]


def elastic(x, y, first, shear, points):
    (mx, bx, kx), (my, by, ky) = x.all_pairs(points), y.all_pairs(points)
    xx = (first + 2 * shear) * sparse.kron(kx, my) + shear * sparse.kron(mx, ky)
    yy = (first + 2 * shear) * sparse.kron(mx, ky) + shear * sparse.kron(kx, my)
    xy = first * sparse.kron(bx.T, by) + shear * sparse.kron(bx, by.T)
    return sparse.bmat([[xx, xy], [xy.T, yy]])


def with_pressure(x, y, first, shear, points):
    (mx, bx, kx), (my, by, ky) = x.all_pairs(points), y.all_pairs(points)
    divergence = sparse.hstack([sparse.kron(bx, my), sparse.kron(mx, by)]).tocsc()
    h = LENGTH / (x.count - x.degree)
    of_pressure = sparse.kron(mx, my) / first + 0.001 * h * h / (2 * shear) * (sparse.kron(kx, my) + sparse.kron(mx, ky))
    return elastic(x, y, 0, shear, points) + divergence.T @ sparse.csr_matrix(spsolve(of_pressure.tocsc(), divergence))


def ridge(elements, rows, poisson, capillarity, way=("full",), degree=2):
    """Largest vertical displacement of the top."""
    first, shear = YOUNG * poisson / ((1 + poisson) * (1 - 2 * poisson)), YOUNG / (2 * (1 + poisson))
    x, y = RuledSplines(LENGTH, elements, degree), RuledSplines(HEIGHT, rows, degree)
    if way[0] == "full":
        stiffness = elastic(x, y, first, shear, degree + 1)
    elif way[0] in ("means", "points"):
        part = min(first, way[1] * shear)
        stiffness = elastic(x, y, part, shear, degree + 1) + elastic(x, y, first - part, 0, way[2] if way[2:] else 0)
    else:
        stiffness = with_pressure(x, y, first, shear, degree + 1)
    return highest_point(x, y, stiffness, capillarity)


if __name__ == "__main__":
    cap = 2 * 0.4 / (1 - 2 * 0.4)
    ways = [(("full",), 2), (("means", cap), 2), (("full",), 3), (("means", cap), 3), (("pressure",), 2),
            (("points", cap, 2), 2), (("points", 16, 1), 2), (("points", 16, 1), 3), (("means", 0), 2), (("means", 9), 2)]
    print("full, means, full 3, means 3, pressure; 2 x 2 points; centres, centres 3; all means; split at nu = 0.45")
    for elements, rows, width in ((64, 8, 2), (64, 8, 3), (64, 8, 4), (128, 16, 2)):
        for nu in (0.45, 0.49, 0.4999):
            exact = ridge(2 * elements, 2 * rows, nu, width / elements, degree=5)
            errors = [f"{100 * (ridge(elements, rows, nu, width / elements, way, degree) / exact - 1):+.2f}"
                      for way, degree in ways]
            print(f"| {elements} x {rows} | {width} | {nu} | {' | '.join(errors[:5])} |   {' '.join(errors[5:])}", flush=True)
