"""Body forces: energy, gradient, mean force and direction, one file for each."""
