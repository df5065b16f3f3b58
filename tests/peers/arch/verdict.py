"""What must hold of the tables, on any machine."""

from .results import read_lattices
from .tables import read

LATTICE = 0.05  # at cells of no size; from d/12 and d/18, touching spheres are 0.04 low
CONTROL = 0.1  # of the spheres: rattlers that only wound-up friction held
BALANCE = 0.01  # shear at inlet and outlet is left out


def faults(data):
    """Lines; none when all is well."""
    lines = []
    for found in read_lattices(data):
        off = found.limit() / found.exact - 1
        if abs(off) > LATTICE:
            lines.append(f"lattice {found.solid}: K is off by {off:+.3f} (limit {LATTICE})")
    for row in read(data / "cases.csv"):
        off = float(row["balance"]) - 1
        if abs(off) > BALANCE:
            lines.append(f"clog {row['seed']}, {row['cells']} cells: forces are {off:+.4f} off the balance (limit {BALANCE})")
    for row in read(data / "stand.csv"):
        if row["forces"] == "law" and int(row["moved"]) > CONTROL * int(row["watched"]):
            lines.append(f"clog {row['seed']} does not stand under the law's own forces")
    return lines
