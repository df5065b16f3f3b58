#!/usr/bin/env python3
"""Writes pore.stl, the walls of scenes/pore.toml: scenes/make_pore.py > scenes/pore.stl

A straight channel of 300 um x 100 um that narrows smoothly, without an edge along the flow, to a pore of
100 um x 100 um whose four corners are rounded by 30 um. Lengths in micrometres, normals out of the fluid.
"""
import math

WIDE, NECK, HEIGHT, CORNER = 300.0, 100.0, 100.0, 30.0
STRAIGHT, NARROWING, NECK_LENGTH = 300.0, 180.0, 100.0
SLICES, CORNER_STEPS = 14, 4


def ring(x, share):
    """Corners of the section at x: share 0 is the wide rectangle, 1 the neck with its round corners."""
    half, radius = (WIDE + share * (NECK - WIDE)) / 2, share * CORNER
    points = []
    for quarter, (y, z) in enumerate([(half, 0), (half, HEIGHT), (-half, HEIGHT), (-half, 0)]):
        cy, cz = y - math.copysign(radius, y), radius if z == 0 else HEIGHT - radius
        for i in range(CORNER_STEPS + 1):
            angle = math.pi / 2 * (quarter - 1 + i / CORNER_STEPS)
            point = (x, cy + radius * math.cos(angle), cz + radius * math.sin(angle))
            points.append(tuple(round(c, 3) + 0.0 for c in point))
    return points


def smooth(t):
    return t * t * (3 - 2 * t)


def facets(name, triangles):
    print("solid", name)
    for a, b, c in triangles:
        if len({a, b, c}) < 3:
            continue  # the corners of the rectangle are arcs without length
        print("facet normal 0 0 0\nouter loop")
        for corner in (a, b, c):
            print("vertex %g %g %g" % corner)
        print("endloop\nendfacet")
    print("endsolid", name)


def cap(points):
    middle = (points[0][0], 0.0, HEIGHT / 2)
    return [(middle, points[i], points[(i + 1) % len(points)]) for i in range(len(points))]


rings = [ring(-NARROWING - STRAIGHT, 0)]
rings += [ring(-NARROWING * (1 - i / SLICES), smooth(i / SLICES)) for i in range(SLICES + 1)]
rings.append(ring(NECK_LENGTH, 1))

walls = []
for before, after in zip(rings, rings[1:]):
    for i in range(len(before)):
        j = (i + 1) % len(before)
        walls += [(before[i], after[i], after[j]), (before[i], after[j], before[j])]
facets("walls", [(a, c, b) for a, b, c in walls])
facets("inlet", [(a, c, b) for a, b, c in cap(rings[0])])
facets("outlet", cap(rings[-1]))
