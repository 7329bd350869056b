import numpy as np
import numpy.typing as npt
from skfem import BilinearForm

_Number = float | npt.NDArray[np.float64]

def lame_parameters(E: _Number, nu: _Number) -> tuple[_Number, _Number]: ...
def linear_elasticity(Lambda: _Number, Mu: _Number) -> BilinearForm: ...
