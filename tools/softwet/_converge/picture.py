"""The picture of `softwet converge`: each column against the width, with both fits and the value at zero."""

import numpy as np
from matplotlib import pyplot as plt

from .._drawing.look import BLUE, GREY, RED, STYLE, letter
from .fits import NEEDED, curve


def draw_fits(path, widths, rows):
    shown = [row for row in rows if row.limit]
    if not shown:
        return
    with plt.rc_context(STYLE):
        figure, all_axes = plt.subplots(1, len(shown), figsize=(3.2 * len(shown), 2.8), squeeze=False, layout="constrained")
        for number, (axes, row) in enumerate(zip(all_axes[0], shown)):
            draw_row(axes, widths, row)
            letter(axes, number)
        figure.savefig(path)
        plt.close(figure)


def draw_row(axes, widths, row):
    finest = min(widths)
    fitted = np.linspace(0, sorted(widths)[NEEDED - 1], 200)
    for line, colour, name in zip(curve(row.limit, finest, fitted), (BLUE, RED), ("$1, g, g^2$", "$1, g, g\\,\\log g$")):
        axes.plot(fitted, line, color=colour, lw=1, label=name)
    axes.plot(widths, row.values, "o", color=GREY, ms=4)
    axes.errorbar([0], [row.limit.value], [row.limit.bar], fmt="ks", ms=4, capsize=3)
    unit = row.column.shown.replace("L0", "$L_0$").replace("um", "µm")
    axes.set(xlabel="fluid.capillarity / $L_0$", ylabel=f"{row.column.text}{' / ' + unit if unit else ''}")
    axes.legend(frameon=False)
