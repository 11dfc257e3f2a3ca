"""The parts of `softwet status` and `softwet watch`: a line about a run, and curves of characters."""
