"""The figures of the paper, a module each: `add_arguments(parser)`, `draw(options)` -> (Figure, rows of its table)."""
