"""docs/reports/resolved_arch.md: the text of page.md.in around tables made of the CSV files, and the figure."""

from pathlib import Path
from string import Template

import numpy as np

from .bed import bed_drop
from .clogs import DIAMETER
from .compare import apart, at_no_shrinkage, compare
from .figure import draw
from .quoted import pooled, projected, quoted
from .resolved import NECK
from .results import read_lattices, read_results

NAMES = {"strips": "strip law", "local": "local porosity", "superficial": "`superficial`", "beetstra": "Beetstra",
         "plug strips": "strip law, plug flow", "plug local": "local porosity, plug flow"}

VELOCITIES = {law: name for law, name in NAMES.items() if law not in ("superficial", "beetstra")}


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + " --- |" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows])


def lattice_table(lattices):
    counts = sorted({count for lattice in lattices for count in lattice.counts})
    rows = []
    for lattice in lattices:
        by_count = dict(zip(lattice.counts, lattice.found)) | {"two": lattice.limit(2), "limit": lattice.limit()}
        rows.append([lattice.solid, lattice.exact]
                    + [f"{by_count[n]:.2f} ({100 * (by_count[n] / lattice.exact - 1):+.1f} %)" if n in by_count else ""
                       for n in (*counts, "two", "limit")])
    return table(["solid fraction", "exact K"] + [f"about d/{n}" for n in counts]
                 + ["no size, from the first two", "no size, from the finest two"], rows)


def mesh_table(clog):
    """Meshes are held against cells of no size, what else was varied against the same mesh without."""
    plain = {case.cells: case.of(clog.rows)[clog.inner] for case in clog.plain()}
    limit = clog.force()[clog.inner]
    rows = []
    for case in clog.cases:
        force = case.of(clog.rows)[clog.inner]
        other = limit if case in clog.plain() else plain[case.cells]
        share = force[:, 0].sum() / other[:, 0].sum()
        rows.append([f"d/{case.cells * DIAMETER / NECK:.1f}", f"{100 * case.shrink:.0f} %", f"{case.start:g} D",
                     f"{1 / case.slower:g}", case.row["mesh cells"], case.row["iterations"],
                     f"{1e9 * force[:, 0].sum():.0f}", f"{share:.3f}", f"{100 * apart(force / share, other):.1f} %",
                     *(f"{compare(force, clog.laws[law][clog.inner]).strength:.3f}" for law in ("strips", "plug local")),
                     f"{case.drop:.1f}", case.row["balance"], f"{100 * float(case.row['covered']):.0f} %"])
    return table(["cells", "shrunk by", "mesh begins at", "flow", "mesh cells", "iterations", "sum of F_x (nN)", "sum over reference",
                  "single forces, sums made equal, differ from it by", "scatter about the strip law",
                  "about local porosity in plug flow", "pressure drop (Pa)", "balance", "surface meshed"], rows)


def ratio_table(clogs):
    rows = []
    for clog in clogs.values():
        for name, where in (("compared", clog.inner), ("narrowing and neck", clog.near())):
            found = [compare(clog.force()[where], clog.laws[law][where]).total for law in NAMES]
            rows.append([clog.seed, name, int(where.sum()), f"{1e9 * clog.force()[where, 0].sum():.0f}"]
                        + [f"{x:.2f}" for x in found])
    for name, where in (("compared", lambda c: c.inner), ("narrowing and neck", lambda c: c.near())):
        both = [pooled(clogs, law, where) for law in NAMES]
        rows.append(["all", name, len(both[0][0]), f"{1e9 * both[0][0][:, 0].sum():.0f}"]
                    + [f"{compare(*pair).total:.2f}" for pair in both])
    return table(["clog", "spheres", "number", "resolved F_x (nN)"] + ["over " + name for name in NAMES.values()], rows)


def place_table(clogs):
    """Ratios by where a sphere is: along x, and from the middle."""
    bands = (("-1.4 D to -0.87 D", -1.4, -0.866), ("-0.87 D to -0.5 D", -0.866, -0.5), ("-0.5 D to the end", -0.5, 9))
    rows = []
    for name, low, high in bands:
        for side, inner, outer in (("middle, y below 0.6 of the half width", 0, 0.6), ("side", 0.6, 2)):
            def where(clog):
                return (clog.inner & (clog.x() >= low) & (clog.x() < high) & (clog.across() >= inner)
                        & (clog.across() < outer))

            number = sum(int(where(clog).sum()) for clog in clogs.values())
            if not number:
                continue
            found = [f"{projected(clogs, law, where):.2f}" for law in VELOCITIES]
            rows.append([name, side, number] + found)
    return table(["x", "across", "spheres"] + ["over " + name for name in VELOCITIES.values()], rows)


def scatter_table(clogs):
    rows = []
    for law, name in VELOCITIES.items():
        each = [compare(clog.force()[clog.inner], clog.laws[law][clog.inner]) for clog in clogs.values()]
        all_of = compare(*pooled(clogs, law, lambda clog: clog.inner))
        rows.append([name, f"{all_of.ratio:.2f}", f"{all_of.along:.2f}", f"{all_of.across:.2f}", f"{all_of.strength:.2f}",
                     f"{min(c.strength for c in each):.2f} to {max(c.strength for c in each):.2f}", f"{all_of.size:.2f}",
                     f"{np.degrees(all_of.angle):.0f}"])
    return table(["law", "factor of least squares", "along", "across, each", "strength", "clog by clog", "sizes over the law's: spread over mean",
                  "median angle (deg)"], rows)


def drop_table(clogs, empty):
    rows = []
    for clog in clogs.values():
        rows.append([clog.seed, f"{clog.drop():.0f}", f"{clog.drop_of(clog.force(), empty):.0f}"]
                    + [f"{clog.drop_of(clog.laws[law], empty):.0f}" for law in ("strips", "local")]
                    + [f"{bed_drop(clog.place, form):.0f}" for form in ("carman", "walls", "ergun")])
    return table(["clog", "resolved (Pa)", "by its forces on spheres", "by the strip law's", "by the local law's", "Carman-Kozeny",
                  "with the channel's walls", "Ergun"], rows)


def stand_table(stands):
    names = list(dict.fromkeys(row["forces"] for row in stands))
    seeds = list(dict.fromkeys(row["seed"] for row in stands))
    cell = {(row["seed"], row["forces"]): f"{row['moved']} of {row['watched']} moved, {row['passed']} passed" for row in stands}
    return table(["forces"] + [f"clog {seed}" for seed in seeds],
                 [[name] + [cell.get((seed, name), "") for seed in seeds] for name in names])


def shrink_table(clogs):
    rows = []
    for clog in clogs.values():
        cases = sorted(clog.shrunk(), key=lambda case: case.shrink)
        if len(cases) < 3:
            continue
        force, drop = ([value(c) for c in cases] for value in (lambda c: 1e9 * c.of(clog.rows)[clog.inner, 0].sum(), lambda c: c.drop))
        shares = [c.shrink for c in cases[1:]]
        rows.append([clog.seed] + [f"{f:.0f}" for f in force] + [f"{at_no_shrinkage(force[1:], shares):.0f}"]
                    + [f"{d:.0f}" for d in drop] + [f"{at_no_shrinkage(drop[1:], shares):.0f}"])
    return table(["clog", "F_x (nN), not shrunk", "1 %", "2 %", "line through both, at 0", "drop (Pa), not shrunk", "1 %", "2 %",
                  "line, at 0"], rows)


def write_page(data, page, picture=None):
    clogs, stands, empty = read_results(data)
    # Those of one mesh are not extrapolated, so they are not compared.
    clogs = {seed: clog for seed, clog in clogs.items() if len(clog.plain()) > 1}
    stands = [row for row in stands if int(row["seed"]) in clogs]
    draw(clogs, {seed: clog.across() for seed, clog in clogs.items()}, picture or data / "forces.png")
    text = Template((Path(__file__).parent / "page.md.in").read_text())
    page.write_text(text.substitute(
        quoted(clogs, empty),
        lattices=lattice_table(read_lattices(data)), meshes=mesh_table(clogs[1]), shrinkage=shrink_table(clogs), ratios=ratio_table(clogs),
        places=place_table(clogs), scatter=scatter_table(clogs), drops=drop_table(clogs, empty), stands=stand_table(stands),
        clogs=len(clogs), spheres=sum(int(clog.inner.sum()) for clog in clogs.values()), empty=f"{empty:.0f}",
        lever=max(clogs[1].plain(), key=lambda case: case.cells).row["lever"]))
