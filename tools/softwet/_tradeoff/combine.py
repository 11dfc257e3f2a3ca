"""Which settings of single parameters `softwet tradeoff` tries together."""

import itertools

from .parameters import Setting
from .table import beaten, near_front

MOST_PARTS, MOST_CANDIDATES, WORTH = 4, 12, 0.95


def candidates(points, base):
    """Settings on or near the front that make the base faster or more accurate by more than 5 %, the best first.
    @param points  [(entry, seconds, error)];  @param base  (entry, seconds, error) of the base"""
    _, seconds, error = base
    near = [point for point in near_front(points) if point[0].kind == "parameter"
            and (point[1] < WORTH * seconds or point[2] < WORTH * error)]
    return sorted(near, key=lambda p: p[1] / seconds * max(p[2] / error, 1e-3) if error else p[1])[:MOST_CANDIDATES]


def expected(parts, base, floor):
    """(seconds, error) that a combination may have: the ratios of the costs are multiplied, and the changes of the
    error are added; the error stays above the error of the reference. It is a guess that chooses what to compute."""
    _, seconds, error = base
    cost = seconds
    for _, s, _ in parts:
        cost *= s / seconds
    return cost, max(error + sum(e - error for _, _, e in parts), floor)


def combinations(points, base, floor, most):
    """At most `most` settings that combine settings of different parameters: those whose expected cost and error no
    member and no other combination is expected to beat, spread evenly along the cost.
    @param floor  estimated error of the reference"""
    tried = []
    for count in range(2, MOST_PARTS + 1):
        for parts in itertools.combinations(candidates(points, base), count):
            keys = [key for entry, _, _ in parts for key in entry.setting.values]
            parameters = [parameter for entry, _, _ in parts for parameter in entry.setting.parameters]
            if len(set(keys)) == len(keys) and len(set(parameters)) == len(parameters):
                values = {key: value for entry, _, _ in parts for key, value in entry.setting.values.items()}
                tried.append((Setting(parameters, values), *expected(parts, base, floor)))
    good = [point for point in tried if not beaten(*point[1:], [*points, *tried])]
    good.sort(key=lambda point: (point[1], point[0].name))
    if len(good) > most:
        good = [good[round(i * (len(good) - 1) / max(1, most - 1))] for i in range(most)]
    return [setting for setting, _, _ in good]
