"""Energy balance on a soft layer under load

With the wall-energy law d/dt of the energy = - dissipation + power of the load + int f_w div_Gamma vh holds for the
semi-discrete equations when the wall's test functions are blended over the fluid like its mesh (fluid.traction =
"blended"); what the sum over the steps from t = 0 to 4 (the ramp) leaves open, as a part of the dissipation, is then
the error of the time scheme. With the functions of one layer of elements
(the default, faster) a part remains that does not depend on the step: the error of the mesh. The solid is 400 times
denser than in Fig. 2 (same Young modulus, same force per volume), so that these steps resolve its elastic waves.
On a rigid wall the energy falls at every accepted step: tests/regression/energy.py."""

import _measure

MINUTES = {"quick": 0.3, "full": 3}
STEPS = (0.025, 0.0125, 0.00625)
SETTINGS = ["fluid.capillarity=1/16", "fluid.wall_law=energy", "load[0].start=2", "load[0].ramp=4", "time.end=4",
            "output.fields.times=[0,4]", "time.tolerance=1e3", "solver.newton.rtol=1e-11", "solver.newton.atol=1e-14",
            "solver.krylov.rtol=1e-4", "substrate.density=400", "substrate.young=0.0018885", "load[0].force=[0.000405375,0]"]


def study(lab):
    rows = []
    for traction in ("blended",) if lab.quick else ("blended", "layer"):
        for mesh in ("32,16",) if lab.quick else ("32,16", "64,32"):
            steps = STEPS[:2] if lab.quick else STEPS
            runs = lab.runs({f"{traction}, {mesh}, dt = {dt}": ("tensotaxis_pull_2d", [
                f"domain.elements=[{mesh}]", *SETTINGS, f"fluid.traction={traction}", f"time.dt_initial={dt}",
                f"time.dt_max={dt}"]) for dt in steps})
            parts = [_measure.balance_error(run.folder, 0, 4) for run in runs.values()]
            rows.append((traction, mesh, *(f"{part:.5f}" for part in parts), *[""] * (len(STEPS) - len(steps))))
            if traction == "layer":
                continue
            for coarse, fine, dt in zip(parts, parts[1:], steps[1:]):
                lab.expect(f"{mesh}: open at dt = {dt} / at twice that", "<= 1/4 + 10 %", f"{fine / coarse:.3f}",
                           fine / coarse <= 0.275)
            lab.expect(f"{mesh}: open at dt = {steps[-1]}", "<= 0.001", f"{parts[-1]:.5f}", parts[-1] <= 0.001)
    lab.table(("traction", "mesh", *(f"dt = {dt}" for dt in STEPS)), rows, "open")
