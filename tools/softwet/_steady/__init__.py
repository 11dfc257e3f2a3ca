"""The parts of `softwet steady --along`."""
