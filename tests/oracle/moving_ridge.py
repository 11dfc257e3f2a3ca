#!/usr/bin/env python3
"""Linear theory of a contact line, and of a droplet, that moves with constant speed over a viscous elastic layer.

The layer [0, H] stands on rollers; its length is a period. Its shear modulus at the frequency w is G (1 + i w tau)
(Kelvin-Voigt), or G (1 + (i w tau)^n) (a power-law gel), and its bulk modulus is elastic. Its face has the surface
tension Y. In the frame of a load that moves with V the wave exp(i k x) has the frequency w = -k V. The load is the one
of tests/oracle/ridge_locking.py: each line pulls with sigma t K(x), and the pressure sigma/R of a droplet pushes. The
drag is the power that the solid takes over V: minus the integral of the traction times the slope of the displacement.
No code of softwet."""

import numpy
from ridge_locking import tractions
from plane_interface import PlaneInterface

HEIGHT, YOUNG, POISSON = 0.125, 0.7554, 0.45
SHEAR, FIRST = YOUNG / (2 * (1 + POISSON)), YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON))
ANGLE = numpy.radians(75)
TENSION = PlaneInterface(0.39).tension


def stiffness(k, first, shear, height=HEIGHT):
    """2 x 2: tractions over displacements of the face, both (sin k x, cos k x). The displacements of the layer are
    (A cosh + B z sinh, (q B - A) sinh - B z cosh) with z = k y and q = 3 - 4 nu."""
    z, q = k * height, (first + 3 * shear) / (first + shear)
    c, s = 0.5 * (1 + numpy.exp(-2 * z)), 0.5 * (1 - numpy.exp(-2 * z))  # over exp(z)
    shape = numpy.array([[c, z * s], [-s, q * s - z * c]])
    stress = k * numpy.array([[2 * shear * s, shear * ((1 - q) * s + 2 * z * c)],
                              [-2 * shear * c, first * (q - 1) * c + 2 * shear * ((q - 1) * c - z * s)]])
    return numpy.moveaxis(stress, -1, 0) @ numpy.linalg.inv(numpy.moveaxis(shape, -1, 0))


def wall(x, traction, delay, tension, exponent=1.0):
    """Displacements u_x, u_y and their slopes at the points x of one period, without their means.
    @param traction  t_x, t_y at x;  delay  V tau;  tension  of the surface"""
    length = x.size * (x[1] - x[0])
    k = 2 * numpy.pi * numpy.fft.rfftfreq(x.size, length / x.size)[1:]
    shear = SHEAR * (1 + (-1j * k * delay) ** exponent) if delay else SHEAR * numpy.ones_like(k, complex)
    matrix = stiffness(k, FIRST + 2 / 3 * (SHEAR - shear), shear)
    matrix[:, 1, 1] += tension * k**2
    t_x, t_y = (numpy.fft.rfft(t)[1:] for t in traction)
    along, up = numpy.linalg.solve(matrix, numpy.stack((1j * t_x, t_y), -1)[..., None])[..., 0].T
    waves = [-1j * along, up, k * along, 1j * k * up]
    return [numpy.fft.irfft(numpy.append(0, wave), x.size) for wave in waves]


def droplet(delay, capillarity, length, radius=0.155, tension=1.0, exponent=1.0, points=4096):
    """A droplet that moves to +x. @param tension  of the surface over the tension of the liquid
    @return x from its middle, u_y, drag"""
    x = (numpy.arange(points) - points // 2) * length / points
    traction = tractions(x, capillarity, radius, ANGLE, 0.0)
    _, up, along_slope, slope = wall(x, traction, delay, tension * TENSION * capillarity, exponent)
    return x, up, -(traction[0] * along_slope + traction[1] * slope).sum() * length / points


def line(delay, capillarity=1 / 64, exponent=1.0, length=4.0, points=8192):
    """One line that pulls upwards, with the liquid to its right and without the pressure of a droplet, on a surface
    with the tension of the liquid. @return its ridge, the place of it, the drag"""
    x = (numpy.arange(points) - points // 2) * length / points
    far = 1e6
    up = tractions(x, capillarity, far / numpy.sin(ANGLE), ANGLE, far)[1]  # the left line of a droplet so large that it has no pressure
    up *= TENSION * capillarity * numpy.sin(ANGLE) / (up.sum() * length / points)
    _, height, _, slope = wall(x, (0 * up, up), delay, TENSION * capillarity, exponent)
    return height.max(), x[height.argmax()], -(up * slope).sum() * length / points


if __name__ == "__main__":
    for exponent in (1.0, 0.55):
        for delay in (0, 0.003, 0.01, 0.03, 0.1):
            print(f"exponent {exponent:g}, V tau {delay:g}: ridge %.4e at %+.4f, drag %.3e" % line(delay, exponent=exponent))
