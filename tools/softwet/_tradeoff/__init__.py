"""The parts of `softwet tradeoff`."""
