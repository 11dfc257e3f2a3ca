"""The value at zero width of a number that is known at widths each half of the one before.

Near the contact line the solid has a corner that the interface rounds off. Elasticity makes the number a + b g + c g^2
there, and the corner itself a + b g + c g log g. A number at a finite width lies between what both say of zero width:
the value is their mean, and the error bar half of what they differ by.

A number that hardly depends on the width changes by what meshes leave open, and a fit would multiply that: where the
last change is small and no smaller than the one before, the finest value counts."""

import math

from dataclasses import dataclass

import numpy as np

NEEDED = 3  # widths
# What meshes of two elements to g leave open: degrees of an angle, and the share of any other number.
LEAST_DEGREES, LEAST_SHARE = 0.15, 2e-3
# The change of a number that hardly depends on the width, over the number, and what stays open of it. docs/converge.md,
# Measured
HARDLY, OPEN = 1e-2, 1e-2


@dataclass(frozen=True)
class Limit:
    """value, bar  at zero width;  powers, logarithm  coefficients of both fits, in g over the finest width"""

    value: float
    bar: float
    powers: tuple
    logarithm: tuple


def bases(x):
    """Both sets of functions at widths x."""
    x = np.asarray(x, dtype=float)
    logs = np.where(x > 0, x * np.log(np.where(x > 0, x, 1)), 0)
    return np.stack([np.ones_like(x), x, x ** 2], -1), np.stack([np.ones_like(x), x, logs], -1)


def limit(widths, values, unit=""):
    """The limit by the three finest widths. @param unit  of the values; @return Limit; None where there are fewer, or a
    value is missing"""
    order = np.argsort(widths)[:NEEDED]
    x, y = np.asarray(widths, dtype=float)[order], np.asarray(values, dtype=float)[order]
    if len(x) < NEEDED or not np.isfinite(y).all():
        return None
    powers, logarithm = (np.linalg.solve(functions, y) for functions in bases(x / x[0]))
    value, spread = (powers[0] + logarithm[0]) / 2, abs(powers[0] - logarithm[0]) / 2
    least = LEAST_DEGREES if unit == "degrees" else LEAST_SHARE * abs(value)
    last, before = abs(y[0] - y[1]), abs(y[1] - y[2])
    if unit != "degrees" and before <= last <= HARDLY * abs(y[0]):
        value, spread, least = y[0], last, OPEN * abs(y[0])
    return Limit(float(value), float(max(spread, least)), tuple(powers), tuple(logarithm))


def curve(found, finest, widths):
    """Both fits at widths. @return two arrays"""
    return tuple(functions @ np.array(fit) for functions, fit in
                 zip(bases(np.asarray(widths) / finest), (found.powers, found.logarithm)))


def digits_of(bar):
    """Decimal places that a value with this error bar is given with: two digits of the bar."""
    return max(0, 1 - math.floor(math.log10(bar))) if bar > 0 and math.isfinite(bar) else 6
