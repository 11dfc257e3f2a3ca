"""The interface between liquid and vapour in a field file, and curves fitted to time series. Only numpy."""

import numpy


def crossings(points, density, level):
    """Points where the density passes `level` along the lines of the mesh, linear in between. Shape (n, 2)."""
    found = []
    for axis in (0, 1):
        p, value = numpy.moveaxis(points, axis, 0), numpy.moveaxis(density, axis, 0) - level
        a, b = value[:-1], value[1:]
        at = numpy.nonzero(a * b < 0)
        t = (a[at] / (a[at] - b[at]))[:, None]
        found.append((1 - t) * p[:-1][at] + t * p[1:][at])
    return numpy.concatenate(found)


def position(x, density, level):
    """Where a density along a line of quadratic elements (corner, middle, corner, ...) first falls through `level`."""
    i = 2 * (int(numpy.nonzero((density[:-1] >= level) & (density[1:] < level))[0][0]) // 2)
    a, b, c = density[i:i + 3] - level
    roots = numpy.roots([2 * (a - 2 * b + c), 4 * b - 3 * a - c, a])  # over the element, in [0, 1]
    inside = [root.real for root in roots if abs(root.imag) < 1e-12 and -1e-9 <= root.real <= 1 + 1e-9]
    return x[i] + min(inside) * (x[i + 2] - x[i])


def circle(points, on_axis=False):
    """Centre x, y and radius, algebraic least squares; on_axis: the centre lies on x = 0."""
    columns = [points[:, 1], numpy.ones(len(points))] if on_axis else [*points.T, numpy.ones(len(points))]
    solution = numpy.linalg.lstsq(numpy.stack(columns, axis=1), -(points**2).sum(axis=1), rcond=None)[0]
    x, y = (0.0, -solution[0] / 2) if on_axis else -solution[:2] / 2
    return x, y, numpy.sqrt(x * x + y * y - solution[-1])


def damped_wave(t, y, rate, drift=True):
    """Fits y = e^(-b t) (c cos w t + d sin w t) + e + f t (the last two only with drift) by Gauss-Newton over (b, w),
    the rest by linear least squares. @param rate  first guess of -b + i w;  @return -b + i w, residual over
    amplitude"""
    def rest(parameters):
        b, w = parameters
        columns = [numpy.exp(-b * t) * numpy.cos(w * t), numpy.exp(-b * t) * numpy.sin(w * t)]
        columns += [numpy.ones_like(t), t] if drift else []
        matrix = numpy.stack(columns, axis=1)
        return matrix @ numpy.linalg.lstsq(matrix, y, rcond=None)[0] - y

    p = numpy.array([-rate.real, rate.imag])
    for _ in range(60):
        r, step = rest(p), 1e-6 * abs(rate)
        slope = numpy.stack([(rest(p + step * e) - rest(p - step * e)) / (2 * step) for e in numpy.eye(2)], axis=1)
        change = numpy.linalg.lstsq(slope, -r, rcond=None)[0]
        change *= min(1.0, 0.2 * abs(rate) / (numpy.abs(change).max() + 1e-300))
        p = p + change
        if numpy.abs(change).max() < 1e-10 * abs(rate):
            break
    return -p[0] + 1j * p[1], numpy.abs(rest(p)).max() / numpy.abs(y - y.mean() * drift).max()
