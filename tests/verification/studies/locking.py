"""Nearly incompressible solid: degree 2 against degree 3 and against selective integration.

A layer 1 x 0.125 between slip sides, on a slip bottom, under a horizontal load on a block in its middle, at rest: the
surface rises on one side and sinks on the other. The rise grows as the layer becomes less compressible. Displacement-based elements
lock as nu goes to 0.5: too stiff on coarse meshes. substrate.volume_quadrature = "selective" cures that. Measured: largest difference of the surface's displacement to a fine
mesh of degree 3, as a part of the largest displacement of that mesh. The reference is checked against itself on half
the mesh."""

import _measure
import numpy
from _case import case, fields, sides

MINUTES = {"quick": 0.1, "full": 0.1}
EXPLICIT = ("the solid comes to rest by the damping of the implicit scheme (rho_inf = 0); explicit schemes leave its waves "
            "undamped, so it swings for ever")
RATIOS = (0.3, 0.45, 0.49, 0.499, 0.4999)
CASE = case("A layer under a horizontal load, at rest in the end.", "layer",
            domain=dict(size=[1.0, 0.125], elements=[32, 4]),
            substrate=dict(thickness=0.125, young=1.0, poisson=0.45),
            load=[dict(box=[[0.4375, 0.0], [0.5625, 0.125]], force=[0.01, 0.0], ramp=5.0)],
            boundary=sides("slip", top="free"),
            time=dict(rho_inf=0.0, tolerance=0.01, end=2000.0),
            solver=dict(newton=dict(rtol=1e-8, atol=1e-11), krylov=dict(rtol=1e-4)),
            output=fields(2000.0))


WAYS = {"degree 2": (2, "full"), "selective": (2, "selective"), "degree 3": (3, "full"), "degree 3, selective": (3, "selective")}


def settings(poisson, way, n):
    degree, quadrature = WAYS[way]
    return [f"substrate.poisson={poisson}", f"domain.degree={degree}", f"domain.elements=[{n},{n // 8}]",
            f"substrate.volume_quadrature={quadrature}"]


def surface(run, points):
    """Displacement of the top at every 1/points."""
    wall = _measure.interface(run.folder)
    chosen = numpy.isin(numpy.round(wall["x_reference"] * points, 6), numpy.arange(points + 1))
    return numpy.stack([wall["displacement_x"][chosen], wall["displacement_y"][chosen]])


def study(lab):
    ratios, meshes, fine = ((0.45, 0.499), (16, 32), 64) if lab.quick else (RATIOS, (16, 32, 64), 128)
    points = 2 * meshes[0]
    wanted = {f"nu = {nu}, {way}, n = {n}": (CASE, settings(nu, way, n)) for nu in ratios
              for way, n in [(way, n) for way in WAYS for n in meshes] + [("degree 3", fine)]}
    runs, rows, found = lab.runs(wanted), [], {}
    for nu in ratios:
        exact = surface(runs[f"nu = {nu}, degree 3, n = {fine}"], points)
        for way in WAYS:
            for n in meshes:
                run = runs[f"nu = {nu}, {way}, n = {n}"]
                u = surface(run, points)
                found[nu, way, n] = numpy.abs(u - exact).max() / numpy.abs(exact).max()
            cells = [f"{100 * found[nu, way, n]:.3f} %" for n in meshes]
            counts = run.record["counts"]
            rows.append((nu, way, f"{numpy.abs(exact).max():.4e}", *cells, f"{numpy.log2(found[nu, way, meshes[-2]] / found[nu, way, n]):.1f}",
                         counts["newton"], counts["krylov"]))
    lab.text(f"n x n/8 elements. Reference: degree 3, n = {fine}. Newton and Krylov iterations: of the run at n = {n}, to rest.")
    lab.table(("nu", "integration", "largest u", *(f"n = {n}" for n in meshes), "order", "Newton", "Krylov"),
              sorted(rows, key=lambda row: -row[0]), "surface")
    middle = meshes[1]
    lab.expect(f"nu = 0.45, degree 2, n = {middle}", "<= 1 %", f"{100 * found[0.45, 'degree 2', middle]:.2f} %",
               found[0.45, "degree 2", middle] <= 0.01)
    for way in ("degree 3", "selective", "degree 3, selective"):
        for nu in ratios:
            lab.expect(f"nu = {nu}, {way}, n = {middle}", "<= 1 %", f"{100 * found[nu, way, middle]:.2f} %",
                       found[nu, way, middle] <= 0.01)
    last = found[nu, "degree 3", meshes[-1]]
    lab.expect(f"reference: nu = {nu}, degree 3, n = {meshes[-1]} against n = {fine}", "<= 0.5 %", f"{100 * last:.3f} %", last <= 0.005)
