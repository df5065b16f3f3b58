"""Numbers that the words of the page quote, from the same tables."""

import numpy as np

from .bed import bed_drop
from .compare import at_no_shrinkage, compare


def pooled(clogs, law, where):
    """Resolved forces and a law's [n, 3] on the spheres of all clogs for which where(clog) is true."""
    return (np.vstack([clog.force()[where(clog)] for clog in clogs.values()]),
            np.vstack([clog.laws[law][where(clog)] for clog in clogs.values()]))


def projected(clogs, law, where):
    """Sum of the resolved forces along the law's direction over that of the law."""
    force, by_law = pooled(clogs, law, where)
    unit = by_law / np.linalg.norm(by_law, axis=1)[:, None]
    return np.sum(force * unit) / np.sum(by_law * unit)


def span(values):
    return f"{min(values):.2f} to {max(values):.2f}"


def quoted(clogs, empty):
    def total(where):
        return compare(*pooled(clogs, "strips", where)).total

    def strength(law, what="strength"):
        return f"{getattr(compare(*pooled(clogs, law, lambda clog: clog.inner)), what):.2f}"

    def over_bed(form):
        return span([(clog.drop() - (0 if form == "walls" else empty)) / bed_drop(clog.place, form) for clog in clogs.values()])

    def shrink_off(clog):
        cases = sorted(clog.shrunk(), key=lambda case: case.shrink)
        sums = [case.of(clog.rows)[clog.inner, 0].sum() for case in cases]
        return 100 * abs(at_no_shrinkage(sums[1:], [case.shrink for case in cases[1:]]) / sums[0] - 1)

    return {
        "shrink_off": f"{max(shrink_off(clog) for clog in clogs.values() if len(clog.shrunk()) > 2):.1f}",
        "total": f"{total(lambda clog: clog.inner):.2f}", "near": f"{total(lambda clog: clog.near()):.2f}",
        "total_span": span([compare(clog.force()[clog.inner], clog.laws["strips"][clog.inner]).total for clog in clogs.values()]),
        "middle": f"{projected(clogs, 'strips', lambda c: c.inner & (c.x() > -0.5) & (c.across() < 0.6)):.2f}",
        "side": f"{projected(clogs, 'strips', lambda c: c.near() & (c.across() >= 0.6)):.2f}",
        "v0": strength("strips"), "plug": strength("plug strips"), "plug_local": strength("plug local"),
        "plug_along": strength("plug local", "along"), "plug_across": strength("plug local", "across"),
        "carman": over_bed("carman"), "walled": over_bed("walls"),
        "law_drop": span([clog.drop() / clog.drop_of(clog.laws["strips"], empty) for clog in clogs.values()]),
        "point_drop": span([clog.drop_of(clog.force(), empty) / clog.drop() for clog in clogs.values()])}
