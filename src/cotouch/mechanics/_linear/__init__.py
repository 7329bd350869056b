"""The linear step: matrices, state, solver, and one NPMI step of a copy."""
