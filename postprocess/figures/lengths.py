"""In which unit a length is shown: micrometres below a millimetre, millimetres from there on."""

from typing import NamedTuple


class Unit(NamedTuple):
    name: str
    per_metre: float


MICRO, MILLI = Unit("µm", 1e6), Unit("mm", 1e3)


def unit_of(*lengths):
    """One unit for all of them [m]: that of the largest."""
    return MILLI if max(lengths) >= 1e-3 else MICRO


def unit_of_scene(geometry):
    """For axes, from the geometry of the statistics: that of the neck; that of a particle where there is no channel."""
    return unit_of(geometry["neck_width"] if geometry["present"] else geometry["diameter"])
