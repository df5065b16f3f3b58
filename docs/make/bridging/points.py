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
    height: float = NECK  # of neck and channel [um]
    spread: float = 0  # standard deviation of the diameters over their mean
    concentration: float = 0  # share of particles in what flows in; 0: as many as fit
    again: bool = False  # a size of the campaign, run for its arches alone
    empty: bool = False  # the suspension comes into an empty channel, and the run ends with its first clog

    def is_base(self):
        return self.height == NECK and self.is_base_but_for_height()

    def is_base_but_for_height(self):
        return (self.friction, self.angle, self.spread, self.empty) == (FULL, 60, 0, False)

    def neck(self):
        """What the flow depends on."""
        return {"geometry.half_angle": f"{self.angle:g} deg", "geometry.neck_height": f"{self.height:g} um"}

    def overrides(self):
        """Keys of the command line, in which a point differs from the scene."""
        sliding, rolling, torsion = self.friction
        keys = {"ensemble.sweep": "[]", "particles.diameter": f"{NECK / self.ratio:.5g} um", "time.end": f"{self.end:g} s",
                "contact.friction.sliding": sliding, "contact.friction.rolling": rolling, "contact.friction.torsion": torsion,
                **self.neck(), "particles.size_spread": self.spread,
                # A clog is at rest for some 30 ms before the column goes back: one snapshot at least shows it.
                "output.snapshot_interval": "20 ms", "output.contacts": "true", "output.series_interval": "10 ms"}
        if self.empty:  # the only start that knows a concentration
            keys |= {"inlet.start": "empty", "inlet.concentration": self.concentration, "unclog.protocol": "stop"}
        return [word for key, value in keys.items() for word in ("--set", f"{key}={value}")]


FINE = (2.05, 2.2, 2.3, 2.4, 2.6, 2.7, 2.8, 2.9, 3.1, 3.2, 3.3, 3.4)
AROUND_THE_STEP = (2.4, 2.5, 2.6, 2.7, 2.8, 2.9, 3.03, 3.1, 3.2, 3.3)
SMALL = NECK / 47
WEAK, SLIDING = (0.6, 0.1, 0.1), (0.6, 0, 0)

POINTS = {
    **{f"size_{ratio:g}": Point(ratio, "1-10", 1.1 if ratio < 2.5 else 1.0) for ratio in FINE},
    "longer_28": Point(NECK / 28, "1-15", 3.2),  # in the place of the campaign's two seeds
    "again_33": Point(NECK / 33, "101-102", 0.4, again=True),
    **{f"angle_{angle}_{um}": Point(NECK / um, "1-10", 1.0, angle=angle) for um, angles in ((47, (30, 45, 75)), (33, (30, 45))) for angle in angles},
    **{f"tall_{ratio:g}": Point(ratio, "1-10", 1.0, height=110) for ratio in AROUND_THE_STEP},
    **{f"flat_{ratio:.3g}": Point(ratio, "1-10", 1.0, height=90) for ratio in (2.9, 3.1, 3.2, 3.3, 3.4, NECK / 28)},
    **{f"spread_{ratio:g}": Point(ratio, "1-10", 1.0, spread=0.05) for ratio in AROUND_THE_STEP if ratio > 2.8},
    **{f"weak_{um}": Point(NECK / um, seeds, end, WEAK) for um, seeds, end in ((47, "1-10", 2.4), (40, "1-10", 2.3))},
    "sliding_47": Point(SMALL, "1-10", 1.0, SLIDING),
    **{f"fed_{share:g}": Point(SMALL, "1-30", 1.0, concentration=share, empty=True) for share in (0, 0.1, 0.2, 0.3)},
    **{f"fed_{share:g}_40": Point(2.5, "1-30", 1.0, concentration=share, empty=True) for share in (0, 0.2, 0.3)},
}

# Diameter [um], seeds, end [s], then what the program committor takes: age, within, copies, push [d].
COPIES = [
    (40, (201,), 0.4, 0, 60, 5, 1e-6),
    (40, (201,), 0.4, 0, 60, 6, 1e-3),
    (40, (201, 202), 0.6, 0, 60, 8, 1e-2),
    (22, (201,), 0.25, 40, 60, 4, 1e-3),
    (22, (201,), 0.2, 40, 60, 4, 1e-2),
    (22, (202, 203), 0.3, 100, 60, 3, 1e-3),
]
COST = {2.5: (0.28, 0.24), 4.545: (4.2, 1.5)}  # core-seconds of a burst and of a copy
