"""What the runs of the silo say: tables, a picture, the page."""

import numpy as np

from silo_codes import OURS, beverloo
from silo_compare import (DEVIATIONS, FEWEST_PACKS, GRAINS, LIMIT, MOMENTS, SHARES, apart_on_same_pack, mean_curve,
                          pairs_apart, ratios, spread, spread_agrees, times_agree)

PACKING = 0.58  # for Beverloo's density
COLOURS = {"LIGGGHTS": "#c8432b", "LAMMPS": "#d99a1c"}


def mean_of(values):
    return np.mean(list(values), axis=0)


def list_of(numbers, digits=3):
    return ", ".join(f"{number:.{digits}f}" for number in numbers)


def list_of_means(rows):
    """Of columns; with the standard error where there are enough rows for one."""
    if len(rows) < FEWEST_PACKS:
        return list_of(rows.mean(axis=0))
    errors = rows.std(axis=0, ddof=1) / np.sqrt(len(rows))
    return ", ".join(f"{mean:.3f} +- {error:.3f}" for mean, error in zip(rows.mean(axis=0), errors))


def few_or_range(numbers, digits):
    """All, or their median, least and most."""
    if len(numbers) < FEWEST_PACKS:
        return list_of(numbers, digits)
    return f"{np.median(numbers):.{digits}f} ({min(numbers):.{digits}f} to {max(numbers):.{digits}f})"


def table(case, runs):
    """\\param runs  by program and pack, ours first"""
    ours = runs[OURS]
    among = spread(list(ours.values()))
    lines = ["| program | packs | 10, 50, 90 % gone (s) | over ours on the same pack | from ours on the same pack, in deviations | "
             f"of {len(MOMENTS)} times among our packs | spheres/s | over Beverloo | million particle-steps/s |",
             "| --- " * 9 + "|"]
    for name, own in runs.items():
        if not own:
            continue
        rate = mean_of(run.rate() for run in own.values())
        cells = [name, str(len(own)), list_of(mean_of(run.emptying_times(SHARES) for run in own.values()))]
        cells.append("" if name == OURS else list_of_means(ratios(own, ours)))
        if among and name != OURS:
            cells += [few_or_range(apart_on_same_pack(own, ours), 1), few_or_range([among.inside(run) for run in own.values()], 0)]
        else:
            cells += ["", ""]
        speed = sum(run.particle_steps(case.step) for run in own.values()) / sum(run.seconds for run in own.values())
        cells += [f"{rate:.0f}", f"{rate / beverloo(case.orifice, PACKING):.2f}", f"{speed / 1e6:.2f}"]
        lines.append("| " + " | ".join(cells) + " |")
    return lines


def left_over_time(runs):
    first = {name: next(iter(own.items())) for name, own in runs.items() if own and name in (OURS, *COLOURS)}
    among = spread(list(runs[OURS].values()))
    last = runs[OURS][min(runs[OURS])].emptying_times([0.95])[0]
    times = among.times[::2] if among else np.linspace(0, last, 10)
    head = ["t (s)", *(f"{name}, pack {number}" for name, (number, _) in first.items())]
    columns = [run.at(times) for _, run in first.values()]
    if among:
        head += ["our packs, mean +- deviation", "least to most"]
    lines = ["| " + " | ".join(head) + " |", "| --- " * len(head) + "|"]
    for k, time in enumerate(times):
        cells = [f"{time:.3f}", *(f"{column[k]:.0f}" for column in columns)]
        if among:
            cells += [f"{among.mean[2 * k]:.0f} +- {among.deviation[2 * k]:.0f}",
                      f"{among.least[2 * k]:.0f} to {among.most[2 * k]:.0f}"]
        lines.append("| " + " | ".join(cells) + " |")
    return lines


def verdict(runs, peers):
    """\\return sentences, whether all agree"""
    said, agree = [], True
    ours = runs[OURS]
    for name in peers:
        if not runs.get(name):
            continue
        among, times = spread_agrees(runs[name], ours), times_agree(runs[name], ours)
        agree = agree and among and times
        said.append(f"{name}, on the same pack as ours: N(t) {'within' if among else '**beyond**'} {DEVIATIONS} deviations, times of "
                    f"emptying {'within' if times else '**beyond**'} {100 * LIMIT:.0f} % (and {GRAINS} grains).")
    if spread(list(ours.values())):
        apart = pairs_apart(list(ours.values()))
        said.append(f"Two of our own packs: {np.median(apart):.1f} deviations apart in the median of all {len(apart)} pairs, at most "
                    f"{max(apart):.1f}.")
    return said, agree


def section(case, runs, peers):
    said, agree = verdict(runs, peers)
    title = f"## {case.spheres} spheres of {case.modulus:.3g} Pa, orifice of {1e3 * case.orifice:.0f} mm radius"
    return [title, "", *table(case, runs), "", *(f"* {sentence}" for sentence in said), "", *left_over_time(runs), ""], agree


def figure(cases, file):
    """\\param cases  pairs of a case and its runs"""
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    picture, panels = plt.subplots(2, len(cases), figsize=(4.6 * len(cases), 6.2), squeeze=False, sharex="col",
                                   height_ratios=[2, 1], constrained_layout=True)
    for (case, runs), (above, below) in zip(cases, panels.T):
        ours = list(runs[OURS].values())
        times, middle = ours[0].times, mean_curve(ours)
        end = 1.1 * np.interp(0.99 * case.spheres, case.spheres - middle, times)
        left = np.array([run.left for run in ours])
        for panel, base in ((above, 0), (below, middle)):
            panel.plot(times, middle - base, color="#1f5fa8", lw=0.8)
            panel.fill_between(times, left.min(0) - base, left.max(0) - base, color="#1f5fa8", alpha=0.3, lw=0,
                               label=f"clogflow, {len(ours)} packs, least to most")
            for name, colour in COLOURS.items():
                for number, run in list(runs.get(name, {}).items())[:1]:
                    panel.plot(times, run.left - base, color=colour, lw=1.2, label=f"{name}, pack {number}")
        above.plot(times, np.maximum(case.spheres - beverloo(case.orifice, PACKING) * times, 0), color="#6b6b6b", lw=1, ls="--",
                   label="Beverloo")
        first = min(runs[OURS])
        below.plot(times, runs[OURS][first].left - middle, color="#1f5fa8", lw=1.2, label=f"clogflow, pack {first}")
        above.set(title=f"{case.spheres} spheres, orifice {1e3 * case.orifice:.0f} mm, {case.modulus:.0e} Pa", ylabel="spheres left", xlim=(0, end))
        below.set(xlabel="t [s]", ylabel="less the mean of our packs")
        above.legend(frameon=False, fontsize=7)
        below.legend(*map(lambda items: items[-1:], below.get_legend_handles_labels()), frameon=False, fontsize=7)
    file.parent.mkdir(parents=True, exist_ok=True)
    picture.savefig(file, dpi=110)


def page(words, given, sections, picture):
    packs = len(given.numbers)
    return "\n".join([
        "# A silo empties, beside LIGGGHTS and LAMMPS", "",
        "Made by `" + " ".join(words) + "`; what is in the file of results is not run again.", "",
        f"The silo of Dosta et al., Comput. Phys. Commun. 296 (2024) 109066: {given.spheres} spheres of 4 mm (there 1e5) in a "
        f"cylinder of {given.radius:g} mm radius (there 100 mm) over a cone of 45 degrees. Particles are softer than there (1e9 Pa),",
        "as each table says, walls 210 times stiffer, 2500 kg/m3, Poisson's ratio 0.2, restitution 0.5 and 0.4 with walls, friction 0.3 "
        f"and 0.2; {packs} packs, poured in our program behind its gate. All begin with the same places, at rest.",
        "Hertz and Mindlin with history, one dashpot for all (tests/peers/dashpot.py), none along the surface. LIGGGHTS and we take "
        "the walls from the same triangles (96 around), LAMMPS from analytic regions.", "",
        f"![Spheres left over time]({picture})", "",
        "* **N(t)** is the number of spheres that are not yet half through the orifice (2 mm long). A peer agrees if, on the same pack, its N(t) "
        f"differs from ours by no more than {DEVIATIONS} standard deviations of the difference",
        f"  of two packs (sqrt(2) of that over our packs) at each of {len(MOMENTS)} times, those at which 5, 10 ... 95 % have left in the mean of our "
        f"packs; and if its times of emptying are ours to {100 * LIMIT:.0f} %.",
        "  Among our packs is: between their least and their most. Of many packs the table has the median, the least and the most; +- is the "
        "standard error of a mean over packs.",
        "* **Moved** is clogflow from places of the same pack moved by 1e-6 d: what chaos does in this time. **Wall friction 0.1** and "
        "**friction 0.2** are what the comparison would see.",
        "* **Falling on** is a peer whose spheres fall on below the orifice. Ours are taken out where they have passed its 2 mm, and so are the "
        "peers' otherwise. Spheres below still bear some of those above: of 10,000 over the wide orifice",
        "  half have left up to 1 % later where they fall on, of 1200 over the narrow one at the same time.",
        "* **With plate** is such a peer whose orifice has its 2 mm of length. There both let a sphere touch the edge twice, as that of the cone "
        "and as that of the plate, and so brake it; we count an edge once.",
        "  One sphere that rolls over it shows that (last table): with the plate both differ from us alike, without it they give our speed. So "
        "peers are compared without.",
        "* **Beverloo's rate** is 0.58 sqrt(g) (D - 1.4 d)^2.5 at a packing of 0.58, made for flat bottoms. Spheres a second are measured "
        "from 20 to 60 % gone.",
        "* **Particle-steps a second** are the spheres that are left, summed over steps, over the processor time of the whole program, one core "
        "(not the wall time: other work ran beside).",
        "* **Dosta et al.'s own numbers** are not compared: of the paper only its record, and the inputs that YADE (examples/DEM2020Benchmark) "
        "publishes for it, could be read. They hold the materials and the step, 1.5e-6 s, but no result.", "",
        *sections])
