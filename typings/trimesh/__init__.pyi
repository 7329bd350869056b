from typing import BinaryIO

import numpy.typing as npt

class Trimesh:
    vertices: npt.ArrayLike
    faces: npt.ArrayLike

class Scene:
    def to_mesh(self) -> Trimesh: ...

def load_scene(file_obj: BinaryIO, file_type: str, *, process: bool) -> Scene: ...
