#!/usr/bin/env python3
"""Writes walls that keys do not give: scenes/make_shapes.py two_necks > scenes/two_necks.stl, and pipe likewise

two_necks: a chamber of 400 um x 100 um whose end wall has two necks, 100 um x 100 um each, side by side, 50 um
of wall between them; both narrow from 150 um over 60 um, so that arches stand as in a single neck.
pipe: a pipe of 300 um whose diameter falls smoothly to 100 um and stays there for 100 um.
silo: a cylinder of 60 mm, 80 mm high, whose flat bottom of 2 mm has an orifice of 20 mm in its middle. It falls along
x, as all flows go.
Lengths in micrometres, of the silo in millimetres; normals out of the fluid.
"""
import math
import sys


def facets(name, triangles):
    print("solid", name)
    for a, b, c in triangles:
        print("facet normal 0 0 0\nouter loop")
        for corner in (a, b, c):
            print("vertex %g %g %g" % corner)
        print("endloop\nendfacet")
    print("endsolid", name)


def prism(outline, height):
    """Walls, inlet and outlet of a flat device from its closed outline in the x-y plane: counter-clockwise corners,
    each with the name of the side that begins there."""
    parts = {"walls": [], "inlet": [], "outlet": []}
    for (a, name), (b, _) in zip(outline, outline[1:] + outline[:1]):
        low_a, low_b, high_a, high_b = (*a, 0), (*b, 0), (*a, height), (*b, height)
        parts[name] += [(low_a, low_b, high_b), (low_a, high_b, high_a)]
    for a, b, c in triangulated([corner for corner, _ in outline]):
        parts["walls"] += [((*a, 0), (*c, 0), (*b, 0)), ((*a, height), (*b, height), (*c, height))]
    return parts


def triangulated(corners):
    """Ears cut off one after another."""
    def turn(a, b, c):
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])

    corners, triangles = list(corners), []
    while len(corners) > 2:
        for i in range(len(corners)):
            a, b, c = corners[i - 1], corners[i], corners[(i + 1) % len(corners)]
            others = [p for p in corners if p not in (a, b, c)]
            if turn(a, b, c) > 0 and not any(
                    turn(a, b, p) >= 0 and turn(b, c, p) >= 0 and turn(c, a, p) >= 0 for p in others):
                triangles.append((a, b, c))
                del corners[i]
                break
    return triangles


def two_necks():
    half, neck, middle, end = 200.0, 100.0, 25.0, 100.0
    taper, wide = -60.0, -560.0
    # One neck lies at y from 25 to 125 um, the other mirrored; each narrows from the whole half of the chamber.
    upper = [((end, middle), "outlet"), ((end, middle + neck), "walls"), ((0.0, middle + neck), "walls"),
             ((taper, half), "walls"), ((wide, half), "inlet")]
    lower = [((wide, -half), "walls"), ((taper, -half), "walls"), ((0.0, -middle - neck), "walls"),
             ((end, -middle - neck), "outlet"), ((end, -middle), "walls"), ((0.0, -middle), "walls"),
             ((taper, 0.0), "walls"), ((0.0, middle), "walls")]
    return prism(upper + lower, 100.0)


def revolved(profile, sides):
    """Walls, inlet and outlet of a round device from the (x, radius) of its wall, inlet first."""
    middle = profile[0][1]

    def ring(x, radius):
        return [(x, round(radius * math.cos(2 * math.pi * k / sides), 4) + 0.0,
                 round(middle + radius * math.sin(2 * math.pi * k / sides), 4)) for k in range(sides)]

    rings = [ring(*place) for place in profile]
    parts = {"walls": [], "inlet": [], "outlet": []}
    for before, after in zip(rings, rings[1:]):
        for i in range(sides):
            j = (i + 1) % sides
            parts["walls"] += [(before[i], after[j], after[i]), (before[i], before[j], after[j])]
    for name, corners, turn in (("inlet", rings[0], 1), ("outlet", rings[-1], -1)):
        centre = (corners[0][0], 0.0, middle)
        for i in range(sides):
            ends = (corners[i], corners[(i + 1) % sides])
            parts[name].append((centre, *ends[::-turn]))
    return parts


def pipe():
    wide, neck = 150.0, 50.0
    straight, narrowing, neck_length, slices = 500.0, 150.0, 100.0, 12

    def smooth(t):
        return t * t * (3 - 2 * t)

    profile = [(-narrowing - straight, wide)]
    profile += [(-narrowing * (1 - i / slices), wide + smooth(i / slices) * (neck - wide)) for i in range(slices + 1)]
    return revolved(profile + [(neck_length, neck)], 48)


def silo(radius=30.0, height=80.0, orifice=10.0, plate=2.0, cone=0.0, sides=48):
    """A cylinder over a flat bottom, or over a cone as high as `cone`; the orifice lies in a plate."""
    corner = [(-cone, radius)] if cone else [(0.0, radius)]
    return revolved([(-cone - height, radius), *corner, (0.0, orifice), (plate, orifice)], sides)


if __name__ == "__main__":
    for part, triangles in {"two_necks": two_necks, "pipe": pipe, "silo": silo}[sys.argv[1]]().items():
        facets(part, triangles)
