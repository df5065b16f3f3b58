"""Dictionary that fits a mesh of cubes to spheres and wedges, in the numbers of foam_case/system/snappyHexMeshDict."""

import numpy as np


def header(name, kind="dictionary"):
    return f"FoamFile {{ version 2.0; format ascii; class {kind}; object {name}; }}\n\n"


def point(p):
    return "(" + " ".join(f"{x:.12g}" for x in p) + ")"


def snappy(problem):
    """Cells whose centres lie in a sphere or a wedge go; what is left is fitted to the surfaces. Where two surfaces are
    nearer than a cell they are bridged: no flow passes there."""
    names = [f"sphere{i:03}" for i in range(len(problem.places))]
    geometry = [f"  {name} {{ type searchableSphere; centre {point(at)}; radius {r:.12g}; }}"
                for name, at, r in zip(names, problem.places, problem.radii)]
    if problem.wedges is not None:
        geometry.append("  slopes.stl { type triSurfaceMesh; name slopes; }")
        names.append("slopes")
    surfaces = [f"    {name} {{ level (0 0); patchInfo {{ type wall; }} }}" for name in names]
    cell = 1 / problem.cells_per_length
    inside = np.array(problem.low) + cell * np.array([0.371, 2.413, 2.457])
    return header("snappyHexMeshDict") + f"""castellatedMesh true;
snap true;
addLayers false;
geometry
{{
{chr(10).join(geometry)}
}}
castellatedMeshControls
{{
    maxLocalCells 10000000;
    maxGlobalCells 10000000;
    minRefinementCells 0;
    nCellsBetweenLevels 1;
    features ();
    refinementSurfaces
    {{
{chr(10).join(surfaces)}
    }}
    resolveFeatureAngle 30;
    refinementRegions {{}}
    locationInMesh {point(inside)};
    allowFreeStandingZoneFaces false;
}}
snapControls
{{
    nSmoothPatch 3;
    tolerance 2;
    nSolveIter 30;
    nRelaxIter 5;
}}
addLayersControls {{ relativeSizes true; layers {{}} expansionRatio 1; finalLayerThickness 1; minThickness 1; }}
meshQualityControls
{{
    maxNonOrtho 65;
    maxBoundarySkewness 20;
    maxInternalSkewness 4;
    maxConcave 80;
    minVol {1e-6 * cell**3:.3g};
    minTetQuality 1e-15;
    minArea -1;
    minTwist 0.02;
    minDeterminant 0.001;
    minFaceWeight 0.05;
    minVolRatio 0.01;
    minTriangleTwist -1;
    nSmoothScale 4;
    errorReduction 0.75;
    relaxed {{ maxNonOrtho 75; }}
}}
mergeTolerance 1e-6;
"""
