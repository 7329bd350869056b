"""What people notice with their hands."""

# The least that people were found to notice: places [m], the others as shares [Rank et al. 2010; Jay et al. 2007].
NOTICED = {"place": 1e-3, "force": 0.07, "drag": 0.13, "mass": 0.21, "stiffness": 0.08}
# Of a human hand [Ns/m].
HAND_DAMPING = 6.5
# The least drag that is noticed beside the hand's own [Ns/m].
NOTICED_DRAG = NOTICED["drag"] * HAND_DAMPING
