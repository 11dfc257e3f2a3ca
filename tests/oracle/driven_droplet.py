#!/usr/bin/env python3
"""What drives a droplet along a layer whose stiffness grows along it, or that has oblique fibres: two formulas of
linear elasticity.

A layer [0, L] x [0, H], clamped below and with rollers at its sides, in plane strain. Its Young modulus is E exp(s (x -
L/2)), and fibres in the direction a have the energy 2 k (a.e.a)^2, which is k/2 (I_4 - 1)^2 of small strains e. A
droplet at rest loads its top as in ridge_locking.py, whose splines it is solved with. The force on the droplet along
the wall is
  slopes   sigma sin(alpha) (phi_left - phi_right), phi = alpha + the slope of the wall towards the liquid at the
  contact line,
  work     int t_y du_y/dx dx: what the load upwards does to the wall as the droplet moves. The pull along the wall does
  the work
           int t_x du_x/dx dx, which the stretch of the wet wall takes: where the wall energy acts on the wall, the pull
           is gone. On a layer that is the same everywhere both works add up to zero. Prints the forces over sigma
           sin(alpha) in degrees: differences of contact angles that drive a droplet on a rigid wall as much. No code of
           softwet."""

import argparse

import numpy
import scipy.sparse as sparse
from ridge_locking import HEIGHT, LENGTH, Splines, interface, tractions
from scipy.sparse.linalg import factorized

ELEMENTS, ROWS, DEGREE = 96, 12, 4


def moduli(young, poisson, stiffness=0.0, angle=0.0):
    """Matrix from (e_xx, e_yy, 2 e_xy) to the stress. @param angle  of the fibres from the wall, in degrees"""
    first, shear = young * poisson / ((1 + poisson) * (1 - 2 * poisson)), young / (2 * (1 + poisson))
    c, s = numpy.cos(numpy.radians(angle)), numpy.sin(numpy.radians(angle))
    along = numpy.array([c * c, s * s, c * s])
    plain = numpy.array([[first + 2 * shear, first, 0], [first, first + 2 * shear, 0], [0, 0, shear]])
    return plain + 4 * stiffness * numpy.outer(along, along)


def stiffness_matrix(x, y, elasticity, weight):
    """@param weight  factor of the moduli at the points of x"""
    strain = ({0: (1, 0), 2: (0, 1)}, {1: (0, 1), 2: (1, 0)})  # of u_x and u_y: {component: derivatives by x and y}
    def product(i, j):
        return sum(elasticity[p, q] * sparse.kron(x.at(x.points, a[0]).T @ sparse.diags(x.weights * weight) @ x.at(x.points, b[0]),
                                                  y.matrix(a[1], b[1]))
                   for p, a in strain[i].items() for q, b in strain[j].items())
    return sparse.bmat([[product(i, j) for j in range(2)] for i in range(2)]).tocsr()


class Layer:
    """@param growth  s of the Young modulus; fibre  (stiffness, angle in degrees)"""

    def __init__(self, young, poisson, growth=0.0, fibre=(0.0, 0.0)):
        self.x, self.y = Splines(LENGTH, ELEMENTS, DEGREE), Splines(HEIGHT, ROWS, DEGREE)
        weight = numpy.exp(growth * (self.x.points - LENGTH / 2))
        matrix = stiffness_matrix(self.x, self.y, moduli(young, poisson), weight)
        if fibre[0]:
            matrix = matrix + stiffness_matrix(self.x, self.y, moduli(0, 0, *fibre), numpy.ones_like(weight))
        self.number = numpy.arange(matrix.shape[0]).reshape(2, self.x.count, self.y.count)
        fixed = numpy.concatenate((self.number[:, :, 0].ravel(), self.number[0, 0], self.number[0, -1]))
        self.free = numpy.setdiff1d(self.number, fixed)
        self.solve = factorized(matrix[self.free][:, self.free].tocsc())

    def top(self, load):
        """Control values of (u_x, u_y) at the top under (t_x, t_y)."""
        right = numpy.zeros(self.number.size)
        right[self.number[:, :, -1]] = [self.x.vector(t) for t in load]
        u = numpy.zeros(self.number.size)
        u[self.free] = self.solve(right[self.free])
        return u[self.number[:, :, -1]]

    def drive(self, angle, capillarity, left, right):
        """The forces (slopes, work, work of the pull along the wall), in degrees. @param left, right  contact lines"""
        alpha = numpy.radians(angle)
        load = tractions(self.x.points, capillarity, 0.5 * (right - left) / numpy.sin(alpha), alpha, 0.5 * (left + right))
        along, upwards = self.top(load)
        rate, liquid = self.x.at(self.x.points, 1), interface()[0].tension * capillarity * numpy.sin(alpha)
        works = [(self.x.weights * t) @ (rate @ u) / liquid for t, u in zip(load, (along, upwards))]
        turn = (self.x.at(numpy.array([left, right]), 1) @ upwards).sum()
        return numpy.degrees([turn, works[1], works[0]])


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--young", type=float, default=0.6)
    parser.add_argument("--poisson", type=float, default=0.45)
    parser.add_argument("--growth", type=float, default=0)
    parser.add_argument("--fibre", type=float, nargs=2, default=[0, 0], metavar=("STIFFNESS", "ANGLE"))
    parser.add_argument("--capillarity", type=float, default=1 / 32)
    parser.add_argument("angles", type=float, nargs="*", default=[60, 75, 105, 120])
    arguments = parser.parse_args()
    layer = Layer(arguments.young, arguments.poisson, arguments.growth, arguments.fibre)
    for angle in arguments.angles:
        foot = 0.16 * numpy.sin(numpy.radians(angle))
        slopes, work, pull = layer.drive(angle, arguments.capillarity, 0.5 - foot, 0.5 + foot)
        print(f"contact angle {angle:g}: slopes {slopes:+.3f}, work {work:+.3f}, pull along the wall {pull:+.3f} degrees")
