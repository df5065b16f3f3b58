"""OpenFOAM case of a flow past fixed spheres. Lengths in neck widths (or cells of a lattice), velocities in the mean at the inlet.

Schemes, solvers and turbulence model are those of foam_case/; the rest is written here. Every sphere is a patch of its own.
"""

import shutil
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from .channel import stl_text
from .snappy import header, point, snappy

FOAM_CASE = Path(__file__).resolve().parents[3] / "foam_case"
SPHERES = '"sphere[0-9].*"'


@dataclass(frozen=True)
class Problem:
    low: tuple  # corners of the box
    high: tuple
    cells_per_length: int  # along each edge; whole numbers of cells fit the box
    places: np.ndarray  # [n, 3]
    radii: np.ndarray  # [n]
    viscosity: float  # kinematic, over (length times velocity)
    symmetric_sides: bool = False  # else walls
    wedges: np.ndarray | None = None  # triangles of walls that cut the box


def block_mesh(problem):
    (x0, y0, z0), (x1, y1, z1) = problem.low, problem.high
    corners = [(x, y, z) for z in (z0, z1) for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))]
    cells = [round((b - a) * problem.cells_per_length) for a, b in zip(problem.low, problem.high)]
    sides = {"y0": "(0 1 5 4)", "y1": "(3 7 6 2)", "z0": "(0 3 2 1)", "z1": "(4 5 6 7)"}
    if problem.symmetric_sides:
        around = "".join(f"  symmetry_{name} {{ type symmetryPlane; faces ({face}); }}\n" for name, face in sides.items())
    else:
        around = f"  walls {{ type wall; faces ({' '.join(sides.values())}); }}\n"
    return (header("blockMeshDict") + "scale 1;\nvertices\n(\n" + "".join(f"  {point(c)}\n" for c in corners)
            + f");\nblocks ( hex (0 1 2 3 4 5 6 7) {point(cells)} simpleGrading (1 1 1) );\nedges ();\nboundary\n(\n"
            "  inlet { type patch; faces ((0 4 7 3)); }\n  outlet { type patch; faces ((1 2 6 5)); }\n" + around + ");\n")


def field(name, kind, dimensions, inside, boundary):
    rows = "".join(f"  {patch} {{ {entry} }}\n" for patch, entry in boundary.items())
    return header(name, kind) + f"dimensions {dimensions};\ninternalField uniform {inside};\nboundaryField\n{{\n{rows}}}\n"


def fields(problem):
    walls = f'"(walls|slopes|{SPHERES[1:-1]})"'
    mirror = {'"symmetry.*"': "type symmetryPlane;"}
    return {
        "0/U": field("U", "volVectorField", "[0 1 -1 0 0 0 0]", "(1 0 0)", {
            "inlet": "type fixedValue; value uniform (1 0 0);", "outlet": "type zeroGradient;",
            walls: "type noSlip;", **mirror}),
        "0/p": field("p", "volScalarField", "[0 2 -2 0 0 0 0]", "0", {
            "inlet": "type zeroGradient;", "outlet": "type fixedValue; value uniform 0;",
            walls: "type zeroGradient;", **mirror})}


CONTROL = """application simpleFoam;
startFrom latestTime;
startTime 0;
stopAt endTime;
endTime 1500;
deltaT 1;
writeControl timeStep;
writeInterval 1500;
purgeWrite 1;
writeFormat ascii;
writePrecision 10;
functions
{
    total { type forces; libs (forces); patches (%s); rho rhoInf; rhoInf 1; CofR (0 0 0); log no; writeControl timeStep; writeInterval 10; }
}
""" % SPHERES

SAMPLES = """functions
{
    wallShearStress { type wallShearStress; libs (fieldFunctionObjects); patches (".*"); }
    surfaces
    {
        type surfaces; libs (sampling); fields (p U wallShearStress); interpolationScheme cell;
        surfaceFormat vtk; formatOptions { vtk { legacy true; format ascii; precision 10; } }
        surfaces
        (
            spheres { type patch; patches (%s); interpolate false; triangulate false; }
            walls { type patch; patches (walls slopes "symmetry.*"); interpolate false; triangulate false; }
            inlet { type patch; patches (inlet); interpolate false; triangulate false; }
            outlet { type patch; patches (outlet); interpolate false; triangulate false; }
        );
    }
}
""" % SPHERES


def write_case(problem, folder):
    """A folder that solve.py can run; what was there is replaced."""
    if folder.exists():
        shutil.rmtree(folder)
    texts = fields(problem) | {
        "system/blockMeshDict": block_mesh(problem),
        "system/snappyHexMeshDict": snappy(problem),
        "system/controlDict": header("controlDict") + CONTROL,
        "system/samplesDict": header("samplesDict") + SAMPLES,
        "system/sceneDict": header("sceneDict") + "relaxationU 0.9;\nresidualU 1e-4;\n",
        "constant/transportProperties": header("transportProperties") + "transportModel Newtonian;\n"
        f"nu {problem.viscosity:.12g};\n"}
    if problem.wedges is not None:
        texts["constant/triSurface/slopes.stl"] = stl_text(problem.wedges, "slopes")
    for name, text in texts.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    for name in ("system/fvSchemes", "system/fvSolution", "constant/turbulenceProperties"):
        shutil.copy(FOAM_CASE / name, folder / name)
