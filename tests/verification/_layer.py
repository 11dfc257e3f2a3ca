"""Linear theory of an elastic layer of height H on a base, plane strain, wave by wave. No code of softwet.

**At rest.** With u_x = a(y) sin kx, u_y = b(y) cos kx the solutions of (lambda + G) grad div u + G Lap u = 0 are, with
e = 3 - 4 nu,

    a = A cosh ky + B ky sinh ky + A' sinh ky + B' ky cosh ky
    b = -A sinh ky + B (e sinh ky - ky cosh ky) - A' cosh ky + B' (e cosh ky - ky sinh ky);

at y = 0 the base gives two conditions: b = sigma_xy = 0 on rollers, a = b = 0 where it is clamped, sigma_xy = kap_t a
and sigma_yy = kap_n b on a foundation of springs [kap_n, kap_t]. sigma_xy = G (a' - k b) and sigma_yy = lambda (k a +
b') + 2 G b' at y = H are the tractions t_x sin kx, t_y cos kx. On rollers and without t_x this is the textbook u_y/t_y
= 2 (1 - nu^2)/(E k) (cosh 2kH - 1)/(sinh 2kH + 2kH); k = 0 is uniaxial strain, H (1 + nu)(1 - 2 nu)/(E (1 - nu)), and
1/kap_n more on springs. Slip sides make these series exact: cosines for t_y, sines for t_x. The surface tension U of
the top pulls with U u_y'' there: it adds U k^2 to the inverse of u_y/t_y. The modulus M of the top pulls with M u_x'':
it adds M k^2 to the inverse of u_x/t_x.

**Swinging** on rollers with e^(i w t), from the potentials of Helmholtz: u = grad phi + (psi_y, -psi_x) with phi = A
cosh(py) cos kx, psi = (B/q) sinh(qy) sin kx, p^2 = k^2 - rho w^2/(lambda + 2 G), q^2 = k^2 - rho w^2/G. The base is
held already. The top asks for sigma_xy = 0 and sigma_yy = -U k^2 u_y: a determinant of 2 x 2 whose first root is the
lowest frequency (Rayleigh, Lamb; U = 0)."""

import numpy
import scipy.optimize


def lame(young, poisson):
    """lambda and G."""
    return young * poisson / ((1 + poisson) * (1 - 2 * poisson)), young / (2 * (1 + poisson))


class Waves:
    """Displacements and stresses of the two solutions that the base allows, over cosh kH."""

    def __init__(self, k, height, young, poisson, clamped, foundation):
        self.k, self.height, self.e = k, height, 3 - 4 * poisson
        self.first, self.shear = lame(young, poisson)
        below = self.all(0.0)
        if foundation:
            base = numpy.array([below[3] - foundation[0] * below[1], below[2] - foundation[1] * below[0]])
        else:
            base = below[[0, 1]] if clamped else below[[1, 2]]
        self.allowed = numpy.linalg.svd(base / numpy.abs(base).max(axis=1, keepdims=True))[2][2:].T

    def all(self, y):
        """4 x 4: (u_x / sin kx, u_y / cos kx, sigma_xy / sin kx, sigma_yy / cos kx) at a height, of A, B, A', B'."""
        k, e, z = self.k, self.e, self.k * y
        up, down = 0.5 * numpy.exp(z - k * self.height), 0.5 * numpy.exp(-z - k * self.height)
        c, s = up + down, up - down
        a, da = numpy.array([c, z * s, s, z * c]), k * numpy.array([s, s + z * c, c, c + z * s])
        b = numpy.array([-s, e * s - z * c, -c, e * c - z * s])
        db = k * numpy.array([-c, (e - 1) * c - z * s, -s, (e - 1) * s - z * c])
        return numpy.array([a, b, self.shear * (da - k * b), self.first * (k * a + db) + 2 * self.shear * db])

    def at(self, y):
        """The same of the two solutions."""
        return self.all(y) @ self.allowed


def displacement(heights, k, height, young, poisson, tension=0.0, clamped=False, modulus=0.0, foundation=None):
    """2 x 2 at each of the heights: (u_x / sin kx, u_y / cos kx) for tractions (t_x sin kx, t_y cos kx) on the top."""
    if k == 0:
        first, shear = lame(young, poisson)
        return numpy.array([numpy.diag([0.0, y / (first + 2 * shear) + (1 / foundation[0] if foundation else 0)])
                            for y in heights])
    waves = Waves(k, height, young, poisson, clamped, foundation)
    top = waves.at(height)
    parts = numpy.linalg.inv(top[2:] + numpy.diag([modulus * k**2, tension * k**2]) @ top[:2])
    return numpy.array([waves.at(y)[:2] @ parts for y in heights])


def compliance(k, height, young, poisson, tension=0.0, clamped=False, modulus=0.0, foundation=None):
    """2 x 2: (u_x, u_y) of the surface for tractions (t_x sin kx, t_y cos kx); clamped: the base; foundation: [kap_n,
    kap_t] below it; else on rollers."""
    return displacement([height], k, height, young, poisson, tension, clamped, modulus, foundation)[0]


class SlowestWave:
    """.omega: its angular frequency. Surface waves are slower than shear waves, or a little faster where the top is
    under tension."""

    def __init__(self, k, height, young, poisson, tension=0.0, density=1.0):
        self.k, self.height, self.tension, self.density = k, height, tension, density
        self.first, self.shear = lame(young, poisson)
        steps = numpy.linspace(0.02, 3, 300) * numpy.sqrt(self.shear / density) * k
        signs = numpy.sign([self.determinant(omega) for omega in steps])
        i = numpy.nonzero(signs[:-1] != signs[1:])[0][0]
        self.omega = scipy.optimize.brentq(self.determinant, steps[i], steps[i + 1], xtol=1e-13)

    def roots(self, omega):
        """p^2 and q^2."""
        return [self.k**2 - self.density * omega**2 / c for c in (self.first + 2 * self.shear, self.shear)]

    def displacement(self, omega, y):
        """Factors of A and B in u_x / sin kx and u_y / cos kx."""
        k, (pp, qq) = self.k, self.roots(omega)
        return numpy.array([[-k * cosh(pp, y), cosh(qq, y)], [pp * sinh(pp, y), -k * sinh(qq, y)]])

    def top(self, omega):
        """What has to vanish at the top, sigma_xy and sigma_yy + U k^2 u_y: factors of A and B."""
        k, (pp, qq), y = self.k, self.roots(omega), self.height
        xy = self.shear * numpy.array([-2 * k * pp * sinh(pp, y), (qq + k**2) * sinh(qq, y)])
        yy = numpy.array([(self.first * (pp - k**2) + 2 * self.shear * pp) * cosh(pp, y), -2 * self.shear * k * cosh(qq, y)])
        return numpy.array([xy, yy + self.tension * k**2 * self.displacement(omega, y)[1]])

    def determinant(self, omega):
        return numpy.linalg.det(self.top(omega))

    def shape(self, y):
        """u_x / sin kx and u_y / cos kx at the heights y; u_y is 1 at the top."""
        row = self.top(self.omega)[0]
        parts = numpy.array([row[1], -row[0]])
        u = numpy.tensordot(parts, self.displacement(self.omega, numpy.append(y, self.height)), (0, 1))
        return u[:, :-1] / u[1, -1]


def cosh(square, y):
    """cosh(r y) with r^2 = square of any sign."""
    return numpy.cosh(numpy.sqrt(square + 0j) * y).real


def sinh(square, y):
    """sinh(r y) / r, which is y where r = 0."""
    r = numpy.sqrt(square + 0j)
    return (numpy.sinh(r * y) / r).real if r else y
