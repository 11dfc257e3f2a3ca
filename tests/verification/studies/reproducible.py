"""Mass to round-off, and the same numbers for any number of threads.

Mass: moments of the density are carried on the reference domain, so what moves the mesh cannot move the mass. Threads:
sums have a fixed order, so history.csv is the same to the last bit."""

import numpy

MINUTES = {"quick": 0.1, "full": 0.6}
CASE = "tensotaxis_pull_2d"


def study(lab):
    size, end = ("[32,16]", 5) if lab.quick else ("[64,32]", 50)
    base = [f"domain.elements={size}", f"fluid.capillarity={'1/16' if lab.quick else '1/32'}", f"time.end={end}",
            f"output.fields.times=[0,{end}]", "domain.grading.fine=everywhere"]
    tight = lab.run("tight", CASE, base + ["solver.newton.rtol=1e-10", "solver.newton.atol=1e-14"])
    drift = numpy.abs(tight.history["mass_drift"]).max()
    lab.expect(f"drift of the mass, Newton 1e-10, t to {end}", "<= 1e-10", f"{drift:.2g}", drift <= 1e-10)
    texts = [(lab.run(f"{n} thread(s)", CASE, base, ["--threads", str(n)]).folder / "history.csv").read_bytes() for n in (1, 2)]
    same = texts[0] == texts[1]
    lab.expect("history.csv of 1 and 2 threads", "identical", "identical" if same else "different", same)


def explicit(lab):
    """A pull on 32 x 16 elements at the temperature 0.7, over the ramp of its load."""
    words = ["domain.elements=[32,16]", "fluid.capillarity=1/16", "fluid.temperature=0.7", "load[0].start=0.3", "load[0].ramp=0.2",
             "load[0].force=[2,0]", "time.end=0.4", "output.fields.times=[]"]
    runs = [lab.run(f"{n} thread(s)", CASE, words, ["--threads", str(n)]) for n in (1, 2)]
    drift = numpy.abs(runs[0].history["mass_drift"]).max()
    lab.expect("drift of the mass", "<= 1e-10", f"{drift:.2g}", drift <= 1e-10)
    same = (runs[0].folder / "history.csv").read_bytes() == (runs[1].folder / "history.csv").read_bytes()
    lab.expect("history.csv of 1 and 2 threads", "identical", "identical" if same else "different", same)
