"""A body made ready for the kernels, its skin, and the tools of its user."""
