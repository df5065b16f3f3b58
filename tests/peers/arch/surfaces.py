"""What the fluid does to each sphere, from the faces of its patch in a solved case.

    F_i = sum of p S - sum of tau |S|          over the faces of sphere i, S pointing into the sphere
          + sum of p a n                       over its holes, where a neighbour or a wall is nearer than a cell
          - mean p times what is left of the sum of all S

p is the pressure over the density and tau OpenFOAM's wallShearStress, the stress of the wall on the fluid. The surface of a
real sphere is closed, so a pressure that is the same everywhere pushes it nowhere; that of a meshed one has holes where it
touches. They get the pressure of the nearest face and no shear. The rest is a per mille of the surface. No forces of
lubrication or contact are in F: nothing moves.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

DIRECTIONS = 4000  # looks for holes, a sphere
HOLE = 0.75  # a direction without a face nearer than so many cells is a hole


@dataclass(frozen=True)
class Faces:
    area: np.ndarray  # [n, 3] vectors out of the fluid
    centre: np.ndarray  # [n, 3]
    pressure: np.ndarray  # [n]
    velocity: np.ndarray  # [n, 3]
    shear: np.ndarray  # [n, 3]

    @cached_property
    def size(self):
        return np.linalg.norm(self.area, axis=1)

    @cached_property
    def push(self):
        """[n, 3] of pressure and shear together"""
        return self.pressure[:, None] * self.area - self.shear * self.size[:, None]

    def mean_pressure(self):
        return np.sum(self.pressure * self.size) / np.sum(self.size)

    def flux(self):
        return np.sum(self.velocity * self.area)


def polygons(points, rows):
    """Area vectors and centres of faces, each a list of point numbers; faces are grouped by their number of corners."""
    area, centre = np.zeros((len(rows), 3)), np.zeros((len(rows), 3))
    lengths = np.array([len(row) for row in rows])
    for count in np.unique(lengths):
        which = np.flatnonzero(lengths == count)
        corner = points[np.array([rows[k] for k in which])]
        middle = corner.mean(axis=1)
        edges = corner - middle[:, None]
        parts = np.cross(edges, np.roll(edges, -1, axis=1)) / 2
        total = parts.sum(axis=1)
        length = np.linalg.norm(total, axis=1)
        weight = np.einsum("nkc,nc->nk", parts, total) / np.maximum(length, 1e-300)[:, None] ** 2
        thirds = (edges + np.roll(edges, -1, axis=1)) / 3
        area[which], centre[which] = total, middle + np.einsum("nk,nkc->nc", weight, thirds)
    return area, centre


def read_faces(file):
    """A surface that OpenFOAM sampled from patches, in the old text form of VTK."""
    words = file.read_text().split()
    at = words.index("POINTS")
    count = int(words[at + 1])
    points = np.array(words[at + 3:at + 3 + 3 * count], float).reshape(-1, 3)
    at = words.index("POLYGONS")
    faces, numbers = int(words[at + 1]), np.array(words[at + 3:at + 3 + int(words[at + 2])], int)
    rows, k = [], 0
    while k < len(numbers):
        rows.append(numbers[k + 1:k + 1 + numbers[k]])
        k += numbers[k] + 1
    area, centre = polygons(points, rows)
    values = {}
    for name, width in (("p", 1), ("U", 3), ("wallShearStress", 3)):
        at = words.index(name, words.index("CELL_DATA"))
        values[name] = np.array(words[at + 4:at + 4 + width * faces], float).reshape(-1, width)
    return Faces(area, centre, values["p"][:, 0], values["U"], values["wallShearStress"])


def read_case(folder):
    """{"walls", "inlet", "outlet"} and, if there are any, "spheres": faces of the newest samples."""
    newest = max((folder / "postProcessing" / "surfaces").iterdir(), key=lambda path: float(path.name))
    return {file.stem: read_faces(file) for file in newest.glob("*.vtk")}


def directions(count):
    """Unit vectors, evenly spread."""
    k = np.arange(count) + 0.5
    polar, turn = np.arccos(1 - 2 * k / count), np.pi * (1 + 5**0.5) * k
    return np.column_stack([np.cos(turn) * np.sin(polar), np.sin(turn) * np.sin(polar), np.cos(polar)])


def owners(faces, places, radii):
    """Which sphere each face belongs to."""
    from scipy.spatial import cKDTree
    near = cKDTree(places).query(faces.centre, k=min(8, len(places)))[1].reshape(len(faces.centre), -1)
    off = np.abs(np.linalg.norm(faces.centre[:, None] - places[near], axis=2) - radii[near])
    return near[np.arange(len(near)), np.argmin(off, axis=1)]


@dataclass(frozen=True)
class Loads:
    force: np.ndarray  # [n, 3] on each sphere, over density, speed^2 and length^2
    torque: np.ndarray  # [n, 3] of the shear, about the centre
    covered: np.ndarray  # [n] share of the sphere's surface that the mesh has
    meshed: np.ndarray  # [n, 3] force of the patch alone


def sphere_loads(faces, places, radii, cell):
    from scipy.spatial import cKDTree
    owner, rays = owners(faces, places, radii), directions(DIRECTIONS)
    loads = Loads(*(np.zeros((len(places), 3)) for _ in range(2)), np.zeros(len(places)), np.zeros((len(places), 3)))
    for i, (place, radius) in enumerate(zip(places, radii)):
        mine = np.flatnonzero(owner == i)
        if not len(mine):
            continue
        area, pressure = faces.area[mine], faces.pressure[mine]
        out = faces.centre[mine] - place
        away, nearest = cKDTree(out / np.linalg.norm(out, axis=1)[:, None]).query(rays)
        hole = away * radius > HOLE * cell
        into = -rays[hole] * (4 * np.pi * radius**2 / DIRECTIONS)
        mean = np.sum(pressure * faces.size[mine]) / np.sum(faces.size[mine])
        loads.meshed[i] = faces.push[mine].sum(axis=0)
        loads.force[i] = (loads.meshed[i] + pressure[nearest[hole]] @ into
                          - mean * (area.sum(axis=0) + into.sum(axis=0)))
        loads.torque[i] = np.cross(out, -faces.shear[mine] * faces.size[mine, None]).sum(axis=0)
        loads.covered[i] = 1 - np.mean(hole)
    return loads


def balance(case):
    """Along x: all that the fluid does to spheres and walls, over what inlet and outlet give it [-]."""
    given = 0.0
    for end in ("inlet", "outlet"):
        faces = case[end]
        # Pressure and momentum that enter; viscous stresses on these two planes are left out.
        given -= np.sum(faces.pressure * faces.area[:, 0])
        given -= np.sum(np.einsum("nc,nc->n", faces.velocity, faces.area) * faces.velocity[:, 0])
    taken = sum(case[name].push[:, 0].sum() for name in ("spheres", "walls") if name in case)
    return taken / given
