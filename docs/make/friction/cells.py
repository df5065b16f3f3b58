"""The cells of the friction map: name -> coefficients (sliding, rolling, torsion) and what else differs."""

# Diameters [um] and seeds; no whole number of layers fits the channel at any of them.
SIZES = [((70, 47, 40), 10), ((33, 24.5), 6)]

CELLS = {
    "666": ((0.6, 0.6, 0.6), {}),
    "600": ((0.6, 0, 0), {}),
    "660": ((0.6, 0.6, 0), {}),
    "606": ((0.6, 0, 0.6), {}),
    "611": ((0.6, 0.1, 0.1), {}),
    "6_03": ((0.6, 0.03, 0.03), {}),
    "300": ((0.3, 0, 0), {}),
    "606_pairs": ((0.6, 0, 0.6), {"contact.wall_friction.torsion": 0}),
    "600_walltorsion": ((0.6, 0, 0), {"contact.wall_friction.torsion": 0.6}),
    "666_walls0": ((0.6, 0.6, 0.6), {f"contact.wall_friction.{kind}": 0 for kind in ("sliding", "rolling", "torsion")}),
    "666_mercury": ((0.6, 0.6, 0.6), {"contact.turning": "mercury"}),
    "100": ((0.1, 0, 0), {}),
    "000": ((0, 0, 0), {}),
}

WORDS = {
    "606_pairs": "torsion between particles only",
    "600_walltorsion": "torsion at walls only",
    "666_walls0": "smooth walls",
    "666_mercury": "MercuryDPM's turning",
}


def overrides(name):
    """Words of the command line for a cell."""
    (sliding, rolling, torsion), more = CELLS[name]
    keys = {"geometry.channel_length": "500 um", "inlet.start": "flowing", "unclog.protocol": "stop",
            "output.snapshot_interval": "0 s", "time.end": "250 ms", "contact.friction.sliding": sliding,
            "contact.friction.rolling": rolling, "contact.friction.torsion": torsion, **more}
    return [word for key, value in keys.items() for word in ("--set", f"{key}={value}")]


def words(name):
    """A cell as it is named on the page."""
    coefficients = ", ".join(f"{value:g}" for value in CELLS[name][0])
    return coefficients + (f"; {WORDS[name]}" if name in WORDS else "")
