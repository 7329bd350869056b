import numpy as np
import numpy.typing as npt

class Rotation:
    @staticmethod
    def from_rotvec(rotvec: npt.ArrayLike, degrees: bool = ...) -> Rotation: ...
    def as_matrix(self) -> npt.NDArray[np.float64]: ...
