"""Opens in ParaView what `clog export` wrote into the folder of this file: particles as spheres, walls, flow.

    paraview --script=FOLDER/show_in_paraview.py       or, in ParaView: Tools > Python Shell > Run Script (or Macros > Import)
    xvfb-run -a pvbatch FOLDER/show_in_paraview.py PICTURE.png          the first moment as a picture, without a screen
    xvfb-run -a pvbatch FOLDER/show_in_paraview.py 'PICTURE_%04d.png'   every moment

Particles are coloured by speed; "force [N]", "species" and the others are one click away.
"""

import sys
from pathlib import Path

from paraview.simple import (ColorBy, GetActiveViewOrCreate, GetAnimationScene, GetColorTransferFunction, GetScalarBar, Glyph, Hide,
                             OpenDataFile, Render, ResetCamera, SaveScreenshot, SetActiveSource, Show, Slice, Tube)

WRITTEN_TO = ""  # clog export puts its folder here: ParaView's window does not tell a script where it stands
FOLDER = Path(__file__).resolve().parent if "__file__" in globals() else Path(WRITTEN_TO or ".")
QUALITY = 16  # pieces around a sphere
FORCE = "normal force [N]"  # of the force chains, where contacts were recorded
VELOCITY, RADIUS = "velocity [m/s]", "radius [m]"
WIDTH, HEIGHT = 1600, 700  # of the picture
INK = [0.11, 0.15, 0.2]


def show_particles(file, view):
    """Every particle a sphere of its own radius, coloured by speed."""
    spheres = Glyph(Input=OpenDataFile(str(file)), GlyphType="Sphere")
    spheres.GlyphType.Radius = 1
    spheres.GlyphType.ThetaResolution = spheres.GlyphType.PhiResolution = QUALITY
    spheres.OrientationArray = ["POINTS", "No orientation array"]
    spheres.ScaleArray = ["POINTS", RADIUS]
    spheres.ScaleFactor = 1
    spheres.GlyphMode = "All Points"
    shown = Show(spheres, view)
    ColorBy(shown, ("POINTS", VELOCITY, "Magnitude"))
    shown.RescaleTransferFunctionToDataRangeOverTime()
    shown.SetScalarBarVisibility(view, True)
    colours = GetColorTransferFunction(VELOCITY)
    colours.ApplyPreset("Viridis (matplotlib)", True)
    bar = GetScalarBar(colours, view)
    bar.Title, bar.ComponentTitle = "particle speed [m/s]", ""
    bar.Orientation, bar.WindowLocation, bar.ScalarBarLength = "Horizontal", "Lower Center", 0.4
    bar.TitleFontSize, bar.LabelFontSize, bar.TitleColor, bar.LabelColor = 14, 12, INK, INK
    return spheres


def add_force_chains(file, view):
    """A tube a contact, as wide as its force; waits to be switched on, with spheres that one then sees through."""
    lines = OpenDataFile(str(file))
    lines.UpdatePipeline()
    strongest = max(lines.PointData[FORCE].GetRange()[1], 1e-300) if FORCE in lines.PointData.keys() else 1
    bounds = lines.GetDataInformation().GetBounds()
    tubes = Tube(Input=lines)
    tubes.Scalars = ["POINTS", FORCE]
    tubes.VaryRadius = "By Absolute Scalar"
    tubes.Radius = 0.01 * (bounds[3] - bounds[2]) / strongest
    ColorBy(Show(tubes, view), ("POINTS", FORCE))
    Hide(tubes, view)
    Hide(lines, view)


def show_walls(file, view):
    """Seen through."""
    walls = OpenDataFile(str(file))
    shown = Show(walls, view)
    shown.Opacity = 0.15
    shown.DiffuseColor = INK
    return walls


def add_flow(file, view):
    """A cut half way up, which waits to be switched on: it would hide the particles. U is in m/s."""
    flow = OpenDataFile(str(file))
    flow.UpdatePipeline()
    low, high = flow.GetDataInformation().GetBounds()[4:]
    cut = Slice(Input=flow)
    cut.SliceType.Normal = [0, 0, 1]
    cut.SliceType.Origin = [0, 0, (low + high) / 2]
    ColorBy(Show(cut, view), ("POINTS", "U", "Magnitude"))
    Hide(cut, view)
    Hide(flow, view)


def look_from_above(view, shown):
    """Without perspective, the flow from left to right, all of it in the picture."""
    boxes = [entry.GetDataInformation().GetBounds() for entry in shown]
    low, high = ([pick(box[k + end] for box in boxes) for k in (0, 2, 4)] for pick, end in ((min, 0), (max, 1)))
    middle = [(a + b) / 2 for a, b in zip(low, high)]
    view.CameraParallelProjection = 1
    view.CameraFocalPoint, view.CameraPosition, view.CameraViewUp = middle, [*middle[:2], high[2] + (high[0] - low[0])], [0, 1, 0]
    ResetCamera(view)
    view.CameraParallelScale = max(0.75 * (high[1] - low[1]), 0.55 * (high[0] - low[0]) * HEIGHT / WIDTH)


def save(picture, view):
    """One picture, or where its name has a place for a number one for every snapshot."""
    scene = GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    times = list(scene.TimeKeeper.TimestepValues or [0.0]) if "%" in picture else [None]
    for number, time in enumerate(times):
        if time is not None:
            scene.AnimationTime = time
        SaveScreenshot(picture % number if time is not None else picture, view, ImageResolution=[WIDTH, HEIGHT])


def main():
    chains = sorted(FOLDER.glob("*_contacts.pvd"))
    particles = sorted(set(FOLDER.glob("*.pvd")) - set(chains))
    if not particles and not (FOLDER / "walls.vtp").exists():
        raise SystemExit(f"{FOLDER}: nothing to show (clog export RUN.h5 --out FOLDER writes it)")
    view = GetActiveViewOrCreate("RenderView")
    view.UseColorPaletteForBackground, view.Background = 0, [1, 1, 1]
    picture = sys.argv[-1] if len(sys.argv) > 1 and sys.argv[-1].endswith(".png") else None
    if picture:
        view.ViewSize = [WIDTH, HEIGHT]
    shown = [show_particles(file, view) for file in particles]
    shown += [show_walls(file, view) for file in FOLDER.glob("walls.vtp")]
    for file in chains:
        add_force_chains(file, view)
    for file in sorted(FOLDER.glob("*.hdf")):
        add_flow(file, view)
    GetAnimationScene().PlayMode = "Snap To TimeSteps"
    look_from_above(view, shown)
    SetActiveSource(None)  # or the handles of its shape are drawn
    Render(view)
    if picture:
        save(picture, view)


main()
