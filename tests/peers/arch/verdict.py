"""What must hold of the tables, on any machine."""

from .tables import read

# At the coarsest mesh that is used (d/12) the lattices are within it; what is asked of the comparison is coarser.
LATTICE = 0.1
CONTROL = 0.1  # of the spheres: rattlers that only wound-up friction held
BALANCE = 0.01  # shear at inlet and outlet is left out


def faults(data):
    """Lines; none when all is well."""
    lines = []
    for row in read(data / "lattice.csv"):
        off = float(row["K"]) / float(row["exact"]) - 1
        if float(row["shrink"]) == 0 and abs(off) > LATTICE:
            lines.append(f"lattice {row['solid']}, d/{row['cells a diameter']}: K is off by {off:+.3f} (limit {LATTICE})")
    for row in read(data / "cases.csv"):
        off = float(row["balance"]) - 1
        if abs(off) > BALANCE:
            lines.append(f"clog {row['seed']}, {row['cells']} cells: forces are {off:+.4f} off the balance (limit {BALANCE})")
    for row in read(data / "stand.csv"):
        if row["forces"] == "law" and int(row["moved"]) > CONTROL * int(row["watched"]):
            lines.append(f"clog {row['seed']} does not stand under the law's own forces")
    return lines
