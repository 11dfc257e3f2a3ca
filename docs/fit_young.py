"""Which Young's modulus does a layer have that yields so much? A fit by least squares, for docs/python.md.

A soft layer is pushed to the right at its bottom, in the box of a load, by two forces. Measured was by how much its top
is higher at the right end than at the left one. Start it in the folder that holds cases/. It needs scipy. """

import numpy
from scipy.optimize import least_squares

import softwet

FORCES = [0.08, 0.16]                # of the load, in units of a b / L0
MEASURED = [0.001334, 0.002671]      # differences of height, in units of L0

layer = softwet.Case("cases/solid_layer_2d.toml", {"domain.elements": [32, 4], "output.fields.times": [50]})


def height_difference(young, force):
    case = softwet.Case(layer, {"substrate.young": young, "load[0].force": [force, 0]})
    run = case.run("out/fit", threads=1, progress=False, overwrite=True)
    top = run.interface[50]["displacement_y"]
    return top[-1] - top[0]


def misfit(parameters):
    """Of the compliance 1 / young, in which the layer is nearly linear: few runs are needed."""
    computed = [height_difference(1 / parameters[0], force) for force in FORCES]
    print(f"young = {1 / parameters[0]:.5f}: {computed}")
    return numpy.array(computed) / MEASURED - 1


found = least_squares(misfit, [1.0], bounds=(1e-3, 1e3), xtol=1e-4, diff_step=0.05)
print(f"Young's modulus: {1 / found.x[0]:.4f} rho_0^s a b")
