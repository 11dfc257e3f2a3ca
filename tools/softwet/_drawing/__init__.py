"""Pictures: their look, fields and curves of a run, scenes before a run, scenes in three dimensions."""
