#!/usr/bin/env python3
"""Shape of the plane interface of the van der Waals fluid, in 40-digit decimals.

Prints the rows of tests/unit/fluid/test_interface_profile.cpp. With the part f = (rho - rho_v)/(rho_l - rho_v) and the
distance s from its middle towards the vapour, the first integral g rho' = -sqrt(2 D(rho)) gives
    s/g = int_f^{1/2} (rho_l - rho_v) df / sqrt(2 D),    df = f (1 - f) dz,  f = 1/(1 + exp(-z)), by tanh-sinh
    quadrature in z. The moments, for tests/unit/scene/test_initial.cpp, are moments of f and of f^2 less a sharp step
    at s = 0,
    int (f^n - step) ds / g  and  int (f^n - step) s ds / g^2.                        No code of softwet."""
from decimal import Decimal as N

from wall_energy import Fluid, tanh_sinh

TEMPERATURES = (("0.2", "1e-6", "0.95"), ("0.39", "0.0013", "0.867"), ("0.85", "0.107", "0.602"))  # and densities to start from
PARTS = ("1e-9", "1e-4", "0.01", "0.1", "0.3", "0.7", "0.9", "0.99", "0.9999")


def part(z):
    return 1 / (1 + (-z).exp())


class Interface:
    def __init__(self, *scene):
        self.fluid = Fluid(*scene)
        self.fluid.continuation = N(0)
        self.jump = self.fluid.liquid - self.fluid.vapour

    def rate(self, z):
        """-d(s/g)/dz"""
        f = part(z)
        return self.jump * f * (1 - f) / (2 * self.fluid.excess(self.fluid.vapour + self.jump * f)).sqrt()

    def distance(self, z):
        """s/g"""
        return -tanh_sinh(self.rate, N(0), z) if z > 0 else tanh_sinh(self.rate, z, N(0))

    def moments(self, power, end=34, panels=68):
        """Panels of Gauss-Legendre in z on either side, with the distance summed up on the way."""
        first = second = N(0)
        step = N(end) / panels
        for side in (-1, 1):
            distance = N(0)
            for k in range(panels):
                rate = lambda u: self.rate(side * (step * k + u))
                for t, weight in gauss(step):
                    here = distance - side * sum(w * rate(u) for u, w in gauss(t))
                    excess = part(side * (step * k + t)) ** power - (1 if side > 0 else 0)
                    first += weight * rate(t) * excess
                    second += weight * rate(t) * excess * here
                distance -= side * sum(w * rate(u) for u, w in gauss(step))
        return first, second


def gauss(length):
    """Points and weights of 8-point Gauss-Legendre on [0, length]."""
    x = ("0.1834346424956498", "0.5255324099163290", "0.7966664774136267", "0.9602898564975363")
    w = ("0.3626837833783620", "0.3137066458778873", "0.2223810344533745", "0.1012285362903763")
    return [(length * (1 + sign * N(xi)) / 2, length * N(wi) / 2) for xi, wi in zip(x, w) for sign in (-1, 1)]


if __name__ == "__main__":
    for scene in TEMPERATURES:
        interface = Interface(*scene)
        for f in map(N, PARTS):
            z = (f / (1 - f)).ln()
            print(f"{{{scene[0]}, {float(f):.4g}, {float(interface.distance(z)):.15g}}},", flush=True)
    print("moments of f and of f^2 at 0.85:", [f"{float(m):.12g}" for p in (1, 2) for m in Interface(*TEMPERATURES[-1]).moments(p)])
    print("moments of f at 0.39:", [f"{float(m):.12g}" for m in Interface(*TEMPERATURES[1]).moments(1)])
