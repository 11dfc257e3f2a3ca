"""Fig. 5: two droplets pushed together by two loads in three dimensions. A, B: start and end; C: the surface along the
diagonal. The table is the one of Fig. 4, for both droplets; a droplet that has merged into the other has no entry."""

from pathlib import Path

from . import fig4

TIMES = (66.0, 240.0, 267.0, 314.0)


def add_arguments(parser):
    parser.add_argument("folder", metavar="OUT", type=Path, help="output folder of cases/fig5_coalescence_3d.toml")
    fig4.add_view(parser, TIMES)


draw = fig4.draw
