import numpy.typing as npt
from matplotlib.artist import Artist

class Poly3DCollection(Artist):
    def __init__(self, verts: npt.ArrayLike, **kwargs: object) -> None: ...
