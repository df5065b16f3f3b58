"""The committed studies of cost against error, and how their numbers are written."""

import json
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
FOLDER = ROOT / "docs" / "reports" / "trade"
SHARES = {"early_clogs", "share_censored"}
SHORT = {"mean_burst": "`<s>`", "early_clogs": "early clogs", "flow_rate_flowing": "flow rate", "packing_near_neck": "packing near the neck",
         "coordination": "coordination", "alpha": "alpha", "share_censored": "arrests cut by the end"}
NECK = 100e-6  # [m]


class Study:
    """What `clog trade` wrote of one scene."""

    def __init__(self, name):
        self.data = json.loads((FOLDER / f"{name}.json").read_text(encoding="utf-8"))
        self.ratio = NECK / self.data["diameter"]
        self.settings = {s["name"]: s for s in self.data["settings"] if "runs" in s}

    def doses(self):
        return [s for s in self.settings.values() if "within" in s]


def percent(value, digits=2):
    return f"{100 * value:+.{digits}g}" if abs(value) < 1 else f"{100 * value:+.0f}"


def interval(d, unit=True, key=""):
    """Difference with its interval, in % (points of a share)."""
    if d is None or d.get("difference") is None or d["low"] is None:
        return "-"
    text = f"{100 * d['difference']:+.1f} [{100 * d['low']:+.1f}, {100 * d['high']:+.1f}]"
    return text + ((" points" if key in SHARES else " %") if unit else "")


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "| " + " | ".join("---" for _ in head) + " |"]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows])


def short(value):
    return f"{value:.3g}" if abs(value) < 1000 else f"{value:.0f}"
