"""The figures of the paper, one module each: `add_arguments(parser)`, `draw(options)` -> (Figure, rows of its table)."""
