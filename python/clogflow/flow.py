"""The velocity of the undisturbed fluid: flow.h5."""

from functools import cached_property
from pathlib import Path

import numpy as np

from .errors import FileError
from .hdf5 import opened
from .scene import Scene

FORMAT = "clogflow flow"


class Flow:
    """The velocity V0 on a regular grid, the walls, and where they come from.

    x along the flow with the neck's entrance at 0, y across, z upwards from 0. Arrays are as in the file, slowest index
    first: `flow.velocity[k, j, i]` is V0 at (flow.x[i], flow.y[j], flow.z[k]). SI units. Raises FileError where the file
    is missing, cut short, damaged or of another kind.
    """

    def __init__(self, path: str | Path) -> None:
        self.path = Path(path)
        with opened(self.path, FORMAT) as file:
            extent = file.attribute("VTKHDF", "WholeExtent")
            self.origin = file.attribute("VTKHDF", "Origin").astype(float)  #: of the first point [m]
            self.spacing = float(file.attribute("VTKHDF", "Spacing")[0])  #: along all axes [m]
            self.points = tuple(int(last) + 1 for last in extent[1::2])  #: along x, y, z
            self.scene = Scene(file.text("provenance/scene"), str(self.path))
            self.hash = file.text("provenance/hash")  #: of what decides the flow: names it
            self.provenance: dict = file.record()  #: OpenFOAM's version, cells, residuals ...: files/flow_record.hpp
            shape = file.dataset("VTKHDF/PointData/U", "m/s").shape
        if shape != (*self.points[::-1], 3):
            raise FileError(f"{self.path}: the velocity does not have the shape of the grid (the file is damaged)")

    def _axis(self, axis: int) -> np.ndarray:
        return self.origin[axis] + self.spacing * np.arange(self.points[axis])

    @property
    def x(self) -> np.ndarray:
        """[nx] [m]"""
        return self._axis(0)

    @property
    def y(self) -> np.ndarray:
        """[ny] [m]"""
        return self._axis(1)

    @property
    def z(self) -> np.ndarray:
        """[nz] [m]"""
        return self._axis(2)

    @cached_property
    def velocity(self) -> np.ndarray:
        """[nz, ny, nx, 3] V0, single precision [m/s]"""
        with opened(self.path, FORMAT) as file:
            return file.numbers("VTKHDF/PointData/U", "m/s")

    @cached_property
    def solid(self) -> np.ndarray:
        """[nz, ny, nx] True where there is no fluid"""
        with opened(self.path, FORMAT) as file:
            return file.numbers("VTKHDF/PointData/solid", "1").astype(bool)

    @cached_property
    def walls(self) -> np.ndarray:
        """[n, 3, 3] corners of triangles, counter-clockwise seen from the fluid [m]"""
        with opened(self.path, FORMAT) as file:
            return file.numbers("walls/triangles", "m")

    def __repr__(self) -> str:
        return f"Flow({str(self.path)!r}: {' x '.join(map(str, self.points))} points, {1e6 * self.spacing:.3g} um apart)"
