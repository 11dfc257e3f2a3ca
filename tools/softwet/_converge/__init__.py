"""The parts of `softwet converge`."""
