"""The design: which runs were made for the law. Around one base, friction 0.6 three times and a half angle of 60 degrees,
D/d goes in fine steps; the angle, the friction and the feed are changed one at a time."""

from dataclasses import dataclass

NECK = 100  # um
FULL = (0.6, 0.6, 0.6)
SCENE = "scenes/campaign.toml"


@dataclass
class Point:
    ratio: float  # D/d
    seeds: str
    end: float  # of a run [s]
    friction: tuple = FULL
    angle: float = 60  # half angle of the narrowing [degrees]
    concentration: float = 0  # share of particles in what flows in; 0: as many as fit
    again: bool = False  # a size of the campaign, run for its arches alone

    def is_base(self):
        return (self.friction, self.angle, self.concentration) == (FULL, 60, 0)

    def overrides(self):
        """Keys of the command line, in which a point differs from the scene."""
        sliding, rolling, torsion = self.friction
        keys = {"ensemble.sweep": "[]", "particles.diameter": f"{NECK / self.ratio:.5g} um", "time.end": f"{self.end:g} s",
                "contact.friction.sliding": sliding, "contact.friction.rolling": rolling, "contact.friction.torsion": torsion,
                "geometry.half_angle": f"{self.angle:g} deg", "inlet.concentration": self.concentration,
                # A clog is at rest for some 30 ms before the column goes back: one snapshot at least shows it.
                "output.snapshot_interval": "20 ms", "output.contacts": "true", "output.series_interval": "10 ms"}
        return [word for key, value in keys.items() for word in ("--set", f"{key}={value}")]


FINE = (2.05, 2.2, 2.3, 2.4, 2.6, 2.7, 2.8, 2.9)
AGAIN = (2.128, 2.5, 3.03)  # sizes of the campaign, for their arches

POINTS = {f"size_{ratio:g}": Point(ratio, "1-10", 1.0) for ratio in FINE}
