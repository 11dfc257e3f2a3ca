"""Soft layer: height under a load, and under a droplet.

A horizontal load f on the area A of a layer on rollers raises the side that it compresses over the other side by
nu (1 + nu) f A / E far from the load (linear theory, plane strain). Under a droplet at rest the layer has a ridge at the contact line, a
dimple beneath the droplet and a far field. The bounds of these three come from no formula. They are the rounded ranges
that an independent solver of the same scene gave (docs/reference_numbers.md; ridge 5 to 6e-3, dimple -2.5 to -3e-3, far field about -3.5e-4, here
with +- 1e-5). The study soft_layer compares a wall under a droplet with linear theory."""

import _measure

MINUTES = {"quick": 0.1, "full": 0.4}
EXPLICIT = ("the solid comes to rest by the damping of the implicit scheme (rho_inf = 0); explicit schemes leave its waves "
            "undamped, so it swings for ever")


def study(lab):
    # The load in the middle: in the case itself it is 1.6 thicknesses from the right side, and its end effect is 1.8 %.
    run = lab.run("layer", "solid_layer_2d", ["load[0].box=[[0.45,0],[0.55,0.125]]", "load[0].force=[0.016215,0]"])
    wall = _measure.interface(run.folder)["displacement_y"]
    found, exact = wall[-1] - wall[0], 0.45 * 1.45 * 0.016215 * 0.1 * 0.125 / 0.7554
    lab.expect("height difference of the far sides", f"{exact:.6g} +- 0.2 %", f"{found:.6g}", abs(found / exact - 1) <= 0.002)
    if lab.quick:
        return
    wall = _measure.interface(lab.run("droplet", "static_droplet_soft_2d", limit=3000).folder)["displacement_y"]
    for what, value, low, high in (("ridge", wall.max(), 5e-3, 6e-3), ("dimple", wall.min(), -3e-3, -2.5e-3),
                                   ("far field", wall[0], -3.6e-4, -3.4e-4)):
        lab.expect(f"droplet: {what}", f"{low} to {high}", f"{value:.3g}", low <= value <= high)
