"""Papers that softwet is compared with, a module each: `tools/papers` knows the paper by the name of the module.

The docstring of a module has the citation, what is computed and what it is compared with. Its first line is what `--list` shows.
  compute(runs)   starts the runs by `runs.softwet` (see _runs.py). Where `runs.quick` is true they take seconds, so that a test can
                  show that the command works.
  draw(folder)    reads them: (matplotlib Figure, rows of the table with its header, agreement). `agreement` is a list of
                  (quantity, paper or formula, softwet, "agrees" or "does not: why"), all texts.
Names that begin with _ are parts, and no papers. No number of a paper is used to tune a scene."""
