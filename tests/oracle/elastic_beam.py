#!/usr/bin/env python3
"""The beam of Turek and Hron (2006), tests CSM1, CSM2 and CSM3, with its curved end and as a rectangle.

Prints the values of tests/verification/studies/csm.py. No code or method shared with softwet: spectral elements
(Gauss-Lobatto-Legendre nodes of degree N, Gauss quadrature), total Lagrangian Saint Venant-Kirchhoff in plane strain,
assembled sparse tangents, Newton; in time the trapezoidal rule of second order (Newmark, beta 1/4, gamma 1/2).
The published beam is clamped on a circle of radius 0.05 whose rightmost point is x = 0: its corners reach back to
x = sqrt(0.05^2 - 0.01^2) - 0.05 = -1.01e-3. SI units. usage: elastic_beam.py [dynamic curved|rectangle STEP END]"""
import sys

import numpy
import scipy.sparse
import scipy.sparse.linalg

LENGTH, HEIGHT, DENSITY, POISSON, GRAVITY = 0.35, 0.02, 1000.0, 0.4, 2.0


def lobatto(degree):
    """Nodes of Gauss, Lobatto and Legendre on [-1, 1]."""
    inner = numpy.polynomial.legendre.Legendre.basis(degree).deriv().roots()
    return numpy.concatenate(([-1.0], numpy.sort(inner.real), [1.0]))


def lagrange(nodes, at):
    """Values and slopes of the Lagrange polynomials of `nodes`, shape (points, nodes)."""
    coefficient = numpy.linalg.inv(numpy.polynomial.legendre.legvander(nodes, len(nodes) - 1))
    slope = numpy.polynomial.legendre.legder(coefficient, axis=0)
    return (numpy.polynomial.legendre.legvander(at, len(nodes) - 1) @ coefficient,
            numpy.polynomial.legendre.legvander(at, len(nodes) - 2) @ slope)


class Beam:
    """Unknowns: displacement (x, y) of each node, clamped nodes removed."""

    def __init__(self, young, curved, degree, x_breaks, y_breaks):
        self.shear = young / (2 * (1 + POISSON))
        self.first_lame = young * POISSON / ((1 + POISSON) * (1 - 2 * POISSON))
        n, nodes = degree + 1, lobatto(degree)
        gauss, weight = numpy.polynomial.legendre.leggauss(degree + 2)
        value, slope = lagrange(nodes, gauss)
        columns, rows = (len(x_breaks) - 1) * degree + 1, (len(y_breaks) - 1) * degree + 1
        places, elements = numpy.zeros((rows * columns, 2)), []
        for j in range(len(y_breaks) - 1):
            for i in range(len(x_breaks) - 1):
                index = ((j * degree + numpy.arange(n))[:, None] * columns + i * degree + numpy.arange(n)).ravel()
                s = x_breaks[i] + 0.5 * (nodes + 1) * (x_breaks[i + 1] - x_breaks[i])
                y = y_breaks[j] + 0.5 * (nodes + 1) * (y_breaks[j + 1] - y_breaks[j])
                left = numpy.sqrt(0.05**2 - (y - HEIGHT / 2)**2) - 0.05 if curved else 0 * y
                x = left[:, None] * (1 - s / LENGTH) + s
                places[index, 0], places[index, 1] = x.ravel(), numpy.repeat(y, n)
                elements.append(index)
        self.elements, self.places = numpy.array(elements), places
        self.value = numpy.einsum("qi,rj->rqji", value, value).reshape(len(gauss)**2, n * n)
        local = numpy.stack([numpy.einsum("qi,rj->rqji", slope, value), numpy.einsum("qi,rj->rqji", value, slope)],
                            axis=-1).reshape(len(gauss)**2, n * n, 2)
        jacobian = numpy.einsum("enc,qnd->eqcd", places[self.elements], local)
        self.gradient = numpy.einsum("qnd,eqdc->eqnc", local, numpy.linalg.inv(jacobian))
        self.volume = numpy.outer(weight, weight).ravel() * numpy.linalg.det(jacobian)
        self.free = numpy.setdiff1d(numpy.arange(2 * rows * columns),
                                    numpy.concatenate([2 * columns * numpy.arange(rows) + c for c in (0, 1)]))
        self.dofs = (2 * self.elements[:, :, None] + numpy.arange(2)).reshape(len(elements), -1)
        self.tip = 2 * ((rows // 2) * columns + columns - 1) + numpy.arange(2)
        block = numpy.einsum("eq,qn,qm->enm", DENSITY * self.volume, self.value, self.value)
        self.mass = self.assemble(numpy.einsum("enm,cd->encmd", block, numpy.eye(2)))
        self.weight = self.load()

    def load(self):
        f = numpy.zeros(2 * len(self.places))
        numpy.add.at(f, self.dofs[:, 1::2], -GRAVITY * DENSITY * numpy.einsum("eq,qn->en", self.volume, self.value))
        return f[self.free]

    def assemble(self, blocks):
        m = self.dofs.shape[1]
        row, column = numpy.repeat(self.dofs, m, axis=1), numpy.tile(self.dofs, m)
        full = scipy.sparse.csr_matrix((blocks.ravel(), (row.ravel(), column.ravel())), shape=(2 * len(self.places),) * 2)
        return full[self.free][:, self.free]

    def forces(self, u):
        """Elastic forces and their tangent: P = F S, S = lambda tr(E) I + 2 G E."""
        full = numpy.zeros(2 * len(self.places))
        full[self.free] = u
        g, eye = self.gradient, numpy.eye(2)
        f = numpy.einsum("enc,eqnd->eqcd", full.reshape(-1, 2)[self.elements], g) + eye
        strain = 0.5 * (numpy.einsum("eqkc,eqkd->eqcd", f, f) - eye)
        trace = numpy.trace(strain, axis1=2, axis2=3)
        s = self.first_lame * trace[..., None, None] * eye + 2 * self.shear * strain
        r = numpy.zeros_like(full)
        numpy.add.at(r, self.dofs, numpy.einsum("eq,eqck,eqkd,eqnd->enc", self.volume, f, s, g).reshape(len(self.dofs), -1))
        # d E for a unit displacement c of node n: sym(F^T (e_c x grad n))
        half = numpy.einsum("eqcj,eqni->eqncij", f, g)
        de = 0.5 * (half + numpy.swapaxes(half, -1, -2))
        ds = self.first_lame * numpy.trace(de, axis1=-2, axis2=-1)[..., None, None] * eye + 2 * self.shear * de
        material = numpy.einsum("eq,eqncij,eqmdij->encmd", self.volume, de, ds, optimize=True)
        initial = numpy.einsum("eq,eqni,eqij,eqmj->enm", self.volume, g, s, g, optimize=True)
        return r[self.free], self.assemble(material + numpy.einsum("enm,cd->encmd", initial, eye))

    def tip_of(self, u):
        full = numpy.zeros(2 * len(self.places))
        full[self.free] = u
        return full[self.tip]


def static(beam):
    u = numpy.zeros(len(beam.free))
    for part in (0.25, 0.5, 0.75, 1.0):
        for _ in range(30):
            r, k = beam.forces(u)
            step = scipy.sparse.linalg.spsolve(k.tocsc(), r - part * beam.weight)
            u -= step
            if numpy.abs(step).max() < 1e-13:
                break
    return beam.tip_of(u)


def dynamic(beam, dt, end):
    """Times and displacement of the tip from rest at t = 0, trapezoidal rule."""
    u, v = numpy.zeros(len(beam.free)), numpy.zeros(len(beam.free))
    a = scipy.sparse.linalg.spsolve(beam.mass.tocsc(), beam.weight)
    times, tips = [0.0], [beam.tip_of(u)]
    while times[-1] < end - 1e-9:
        start = u + dt * v + 0.25 * dt**2 * a
        u = u + dt * v + 0.5 * dt**2 * a
        for _ in range(20):
            r, k = beam.forces(u)
            residual = beam.mass @ ((u - start) * 4 / dt**2) + r - beam.weight
            step = scipy.sparse.linalg.spsolve((k + 4 / dt**2 * beam.mass).tocsc(), residual)
            u = u - step
            if numpy.abs(step).max() < 1e-11:
                break
        new = (u - start) * 4 / dt**2
        v, a = v + 0.5 * dt * (a + new), new
        times.append(times[-1] + dt)
        tips.append(beam.tip_of(u))
    return numpy.array(times), numpy.array(tips)


def graded(end, count, smallest):
    """0, smallest, then growing geometrically to `end`."""
    low, high = 1.0, 20.0
    for _ in range(80):
        ratio = 0.5 * (low + high)
        low, high = (ratio, high) if smallest * sum(ratio**k for k in range(count)) < end else (low, ratio)
    return numpy.concatenate(([0], numpy.cumsum(smallest * ratio**numpy.arange(count))))


def symmetric(count, smallest):
    half = graded(HEIGHT / 2, count, smallest)
    return numpy.concatenate((half, HEIGHT - half[-2::-1]))


if __name__ == "__main__":
    wanted = sys.argv[1] if len(sys.argv) > 1 else "static"
    if wanted == "static":
        for young in (1.4e6, 5.6e6):
            for curved in (True, False):
                for degree, x_count, y_count, smallest in ((5, 6, 2, 2e-3), (7, 8, 3, 5e-4)):
                    beam = Beam(young, curved, degree, graded(LENGTH, x_count, smallest), symmetric(y_count, smallest))
                    tip = static(beam)
                    print(f"E = {young:.2g} {'curved' if curved else 'rectangle':9} N = {degree}, {x_count} x {2 * y_count}: "
                          f"{1e3 * tip[0]:.6f} {1e3 * tip[1]:.6f} mm", flush=True)
    else:
        shape, dt, end = sys.argv[2], float(sys.argv[3]), float(sys.argv[4])
        beam = Beam(1.4e6, shape == "curved", 4, graded(LENGTH, 6, 1e-2), numpy.array([0, 0.5, 1]) * HEIGHT)
        print("t, ux, uy")
        for t, tip in zip(*dynamic(beam, dt, end)):
            print(f"{t:.6g} {tip[0]:.7e} {tip[1]:.7e}")
