"""Pulled droplets of scenes sampled at random: path and peak speed against fine steps.

The pull of Fig. 2 with contact angle, layer, stiffness, Poisson ratio, size of the droplet, and place, width and force of the load
sampled from the seed that names a scene; the load is 0 to 0.08 away from the droplet, on either side. Each scene starts at rest and
ends at t = 800. Path: largest difference of X_c(t) - X_c(0) to the run with time.tolerance 5e-5, over the range of X_c there. Peak:
the difference of the largest mean speed of the droplet in 5 units of time, after t = 20, over it. Before, the droplet swings, and the mean speed in a
step depends on the length of the step more than on its error, which is why the mean is of one length in all runs. At most one scene in twelve may
miss a bound. No step may jump over a moment in which a droplet begins to move faster: the droplet moves by a part of the width of its
interface in each.

A draft has graded elements and longer steps. It is compared with the same runs, fine steps on equal elements.

The sizes of steps were chosen on the scene of the quick form and on the seed 101; the others were sampled after that. Seeds whose droplet does not
come to rest within 300 steps are left out. The elements are 64 x 32 with twice the capillarity of Fig. 2, so that the droplet is carried over half as many
widths of its interface as on 128 x 64 elements."""

from _sampled import compare

MINUTES = {"quick": 0.2, "full": 9}
EXPLICIT = "takes hundreds of units of time at the temperature 0.39: millions of explicit steps"


def study(lab):
    compare(lab, 64, 0 if lab.quick else 12, 0.75)
