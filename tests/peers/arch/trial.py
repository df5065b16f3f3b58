"""Each arch under other forces than those of the law it grew under."""

import numpy as np

from .compare import compare
from .resolved import CHANNEL, NECK, compared
from .results import read_results
from .stand import go_on
from .tables import Table


def variants(clog, inner, resolved):
    """Forces on all spheres of the run [N]. Those that are not compared get the law's times the mean ratio."""
    law = clog.drag[inner]
    ratio = compare(resolved, law).ratio

    def around(scatter, factor):
        """factor law + scatter (resolved - ratio law), the latter scaled by factor over ratio"""
        forces = factor * clog.drag
        forces[inner] += scatter * factor / ratio * (resolved - ratio * law)
        return forces

    only = clog.drag.copy()
    only[inner] = resolved
    return {"law": clog.drag, "law scaled": around(0, ratio), "resolved": around(1, ratio), "resolved beside law": only,
            **{f"scatter times {factor}": around(factor, ratio) for factor in (2, 4, 8)}}


def try_arch(program, work, data, flow, clog):
    found, inner = read_results(data)[0][clog.seed], compared(clog)
    resolved = found.force()[found.inner]
    watched = inner[clog.place[inner, 0] > -CHANNEL.narrowing * NECK]
    outcomes = Table(data / "stand.csv", ("seed", "forces"))
    for name, wanted in variants(clog, inner, resolved).items():
        print(f"clog {clog.seed} under the forces: {name}", flush=True)

        def compute():
            found = go_on(program, flow, work / f"stand_{clog.seed}_{name}".replace(" ", "_"), clog, wanted, watched)
            return {"watched": len(watched), "passed": found.passed, "moved": found.moved, "way [d]": f"{found.way:.3g}",
                    "speed [m/s]": f"{found.speed:.3g}"}
        outcomes.row(compute, seed=clog.seed, forces=name)
