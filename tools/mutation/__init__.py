"""The parts of tools/mutate: where faults can be put, which, building them all at once, running the tests."""
