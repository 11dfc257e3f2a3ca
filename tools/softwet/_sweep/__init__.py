"""The parts of `softwet sweep`."""
