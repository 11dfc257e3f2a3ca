"""The Pareto picture of `softwet tradeoff`: error against cost."""

from .measures import UNITS
from .table import rated

COST_NAMES = {"seconds": "seconds of the run", "processor": "seconds of processors"}


def draw(path, entries, name, floor, cost, title):
    """Draws the members, with a number and a line of text for each on the front. @return whether matplotlib is there"""
    try:
        from .._drawing.look import BLUE, GREY, RED, STYLE
        import matplotlib.pyplot as plt
    except ImportError:
        return False
    colours = {"base": "black", "parameter": BLUE, "combination": RED}
    plt.rcParams.update(STYLE)
    points, base = rated(entries, name, floor, cost), entries[0]
    shown = [(entry, spent / base.costs[cost], error) for entry, spent, error in points if error > 0]
    figure, axes = plt.subplots(figsize=(8, 5))
    for kind, colour in colours.items():
        mine = [(x, y) for entry, x, y in shown if entry.kind == kind]
        axes.plot(*zip(*mine), "o", color=colour, label=kind, markersize=4) if mine else None
    front = sorted(((x, y, entry) for entry, x, y in shown if entry.front), key=lambda point: point[:2])
    if front:
        axes.step([x for x, _, _ in front], [y for _, y, _ in front], where="post", color=GREY, linewidth=1, zorder=0,
                  label="Pareto front")
    for number, (x, y, _) in enumerate(front, 1):
        axes.annotate(str(number), (x, y), fontsize=8, xytext=(3, 4), textcoords="offset points")
    if floor.get(name):
        axes.axhspan(0, floor[name], color="0.9", label="error of the reference, estimated")
    axes.set(xscale="log", xlabel=f"{COST_NAMES[cost]}, over the base's", title=title,
             ylabel=f"error: {name} [{UNITS[name] or '-'}]", **({"yscale": "log"} if shown else {}))
    lines = [f"{number}  {entry.setting.label}" for number, (_, _, entry) in enumerate(front, 1)]
    if shown:
        axes.legend(fontsize=7)
    figure.text(0.12, 0.0, "\n".join(lines), fontsize=7, va="top")
    figure.savefig(path, dpi=100, bbox_inches="tight", metadata={"Software": None})
    plt.close(figure)
    return True
