"""Writes docs/reports/results.md and its figures. Called by docs/make/make_results with a folder of statistics, one a sweep, and their number."""

import copy
import math
import re
import sys
import tempfile
import tomllib
from pathlib import Path
from string import Template

import claims
import trends as trends_of_experiments
from campaign import Campaign, estimate, number, numerics, over, softness, table

import fig_bursts  # from postprocess/figures, which campaign.py put on the path
import fig_lapses
import fig_spatiotemporal
import fig_trend
import matplotlib
import matplotlib.pyplot as plt
import style
from bursts import fair_sizes  # from docs/make/bridging, likewise
from stats_files import Statistics
from whole_file import rewritten  # from docs/make, likewise

HERE = Path(__file__).resolve().parent
REPORTS = HERE.parents[1] / "reports"


def keep_png(figure, target):
    """Keeps one of the report's figures as the PNG `target`, small enough for a repository."""
    with plt.rc_context({"savefig.dpi": 110}), tempfile.TemporaryDirectory() as folder:
        style.save(figure, folder, "figure")
        with rewritten(REPORTS / "results" / target, binary=True) as file:
            file.write((Path(folder) / "figure.png").read_bytes())


def summary(campaign):
    points = campaign.points
    runs = sum(len(p.group["runs"]) for p in points)
    stops = sum(p.trend["mean_burst"]["stops"] for p in points)
    passages = sum(p.trend["mean_burst"]["passages"] for p in points)
    verdicts = [row[2] for row in claims.rows(campaign)]
    counts = {v: verdicts.count(v) for v in (claims.AGREES, claims.PARTLY, claims.DIFFERS)}
    return (f"{runs} runs at {len(points)} sizes, {stops} clogs, {passages} passages, {number(sum(p.core_hours() for p in points), 2)} core-hours. "
            f"Of the paper's {len(verdicts)} claims below {counts[claims.AGREES]} agree, {counts[claims.PARTLY]} agree in part, "
            f"{counts[claims.DIFFERS]} differ; the rest these runs cannot decide.")


FEW_SEEDS = 5


def drifts(point):
    change = point.quantity("mean_burst")
    few = len(point.group["runs"]) < FEW_SEEDS  # then the spread over seeds says little
    return "-" if few or change["drifts"] is None else f"yes: {estimate(change['change'], 2)}" if change["drifts"] else "no"


def points(campaign):
    head = ["D/d", "d [um]", "seeds", "time [s]", "clogs / passages", "<s>", "<s>, whole", "<s>, tau/2", "restarts nothing follows",
            "drifts", "particles", "packing", "core-hours"]
    rows = []
    for p in campaign.points:
        mean = p.trend["mean_burst"]
        failed = p.quantity("share_failed")["value"]
        rows.append([number(p.ratio), number(1e6 * p.group["geometry"]["diameter"]), len(p.group["runs"]),
                     number(sum(r["end"] - r["start"] for r in p.group["runs"])), f"{mean['stops']} / {mean['passages']}", f"**{estimate(mean)}**",
                     estimate(p.quantity("mean_burst")), estimate(p.quantity("mean_burst_by_threshold")),
                     "-" if failed is None else f"{100 * failed:.3g} %", drifts(p), number(p.group["steady"]["particles"]["value"]),
                     number(p.group["steady"]["packing_fraction"]["value"]), number(p.core_hours(), 2)])
    return table(head, rows)


def law(fit, trend):
    """The fit of <s> along a sweep in words; the refusal when there is none."""
    if "refused" in fit:
        return f"No law fitted: {fit['refused']}."
    text = (f"Law through {fit['points']} points: <s> = A exp(b {fit['x']}), b = {estimate(fit['b'])}, ln A = {estimate(fit['ln_A'])}; chi squared "
            f"{number(fit['chi_squared'])} with {fit['degrees_of_freedom']} degrees of freedom (p = {number(fit['p_value'], 2)}).")
    if fit["extra_scatter"] > 0:
        text += (f" The points scatter by {number(fit['extra_scatter'], 2)} in ln<s> beyond their errors, which the weights and the "
                 "intervals include.")
    for out in fit["left_out"]:
        if out["status"] == "mostly empty":
            x = next(p["x"] for p in trend["points"] if p["group"] == out["group"])
            text += f" Left out: {trend['variable']['name']} = {number(x)}, where more than half of the restarts let nothing pass (the law gives {number(out['law'])} there)."
        if "agrees" in out:
            text += f" A point with a {out['status']} is {'respected' if out['agrees'] else '**not** respected'}: the law gives {number(out['law'])} there."
    return text


def bias(campaign):
    """What the numerics of the campaign do to its <s>, where that was studied."""
    said = []
    for p in campaign.points:
        d = softness(p.ratio)
        if d:
            said.append(f"{100 * d['difference']:+.0f} % [{100 * d['low']:+.0f}, {100 * d['high']:+.0f}] at D/d = {number(p.ratio)}")
    return ", ".join(said)


def memory(campaign):
    """How far bursts are from stopping at random."""
    spread = {p.ratio: p.bursts["standard_deviation"] / p.bursts["standard_deviation_geometric"]
              for p in campaign.points if p.bursts["counted"] >= 20 and p.ratio >= 1.99}
    regular = {r: s for r, s in spread.items() if s < 0.8}
    if not regular:
        return ""
    return (f"**Bursts do not end at random.** From D/d = {number(min(regular))} on their sizes spread by {number(min(regular.values()), 2)} to "
            f"{number(max(regular.values()), 2)} of what a flow that stops at random would show; small bursts are missing. A burst begins in full flow, and an arch "
            "takes a while to form.")


# Free bursts, one a seed, 400 at each size: docs/reports/friction.md, "Again with fresh seeds". By diameter: mean and 95 % interval.
FREE_BURSTS = {47: {"value": 7.25, "low": 6.96, "high": 7.57}, 40: {"value": 12.2, "low": 11.7, "high": 12.8}}


def rewind(campaign):
    """<s> over that of free bursts."""
    said = []
    for diameter, free in FREE_BURSTS.items():
        point = campaign.at(diameter)
        if point is None:
            continue
        said.append(f"at D/d = {number(point.ratio)} it is {estimate(over(point.quantity('mean_burst'), free))} times theirs")
    return (" and ".join(said) or "not compared here") + " ([friction.md](friction.md#again-with-fresh-seeds), other seeds)."


def order(campaign):
    """Whether a burst knows of the one before it."""
    rows = [(p, p.group["burst_order"]["memory"]) for p in campaign.points if p.ratio > 1.5 and (p.group.get("burst_order") or {}).get("memory")]
    if not rows:
        return "too few bursts to say."
    return "correlation of a burst with the next: " + "; ".join(
        f"{number(m['correlation'], 2)} [{number(m['low'], 2)}, {number(m['high'], 2)}] at {number(p.ratio)}" for p, m in rows) + "."


SETTLED = 0.8  # s of a run: then the packing near the neck no longer rises at D/d = 4 and 4.55


def settling(campaign):
    """Mean of the bursts that begin before and after SETTLED, with its standard error over seeds. Late ones count where they end before the
    run does in any case, so that the end cuts no long ones off."""
    said = []
    for p in campaign.points:
        rows = campaign.statistics.rows("bursts", p.index)
        early, late = ([row for row in rows if (row["start [s]"] < SETTLED) == first] for first in (True, False))
        parts = fair_sizes(early, math.inf), fair_sizes(late, p.group["runs"][0]["end"])
        if p.ratio > 3 and all(sum(map(len, part.values())) >= 20 for part in parts):
            said.append(" and ".join(map(with_seed_error, parts)) + f" at {number(p.ratio)}")
    return "; ".join(said)


def with_seed_error(sizes):
    """Mean of all bursts, and its standard error by the scatter of the seeds. \\param sizes  of the bursts, by seed"""
    count = sum(map(len, sizes.values()))
    mean = sum(map(sum, sizes.values())) / count
    return f"{number(mean)} +- {number(math.sqrt(sum((sum(s) - mean * len(s)) ** 2 for s in sizes.values())) / count, 2)}"


def rivals(fit):
    """Which power of D/d makes the straightest line."""
    if not fit.get("rivals"):
        return ""
    head = ["ln<s> as a line in", "slope", "chi squared", "scatter beyond the errors"]
    return "\n\n" + table(head, [[r["x"], estimate(r["b"]), number(r["chi_squared"]), number(r["extra_scatter"], 2)] for r in fit["rivals"]])


def draw_sweep(statistics):
    figure, axes = plt.subplots(figsize=(0.55 * style.PAGE, 2.9))
    fig_trend.draw_mean_burst(axes, statistics)
    return figure


def other_sweep(sweep):
    """A sweep of another key: table, figure and law."""
    name = f"{sweep.key.replace('.', '_')}.png"
    keep_png(draw_sweep(sweep.statistics), name)
    rows = [[value, len(group["runs"]), f"{point['mean_burst']['stops']} / {point['mean_burst']['passages']}", estimate(point["mean_burst"]),
             estimate(group["quantities"]["flow_rate_flowing"]), f"{100 * group['quantities']['share_censored']['value']:.0f} %"]
            for value, point, group in zip(sweep.values(), sweep.points, sweep.groups)]
    head = [f"`{sweep.key}`", "seeds", "clogs / passages", "<s>", "passages per second of flow", "arrests that are permanent"]
    return (f"### `{sweep.key}` at D/d = {number(sweep.ratio)}\n\n{numerics(sweep.groups[0])}.\n\n{table(head, rows)}\n\n![<s> along the sweep](results/{name})\n\n"
            f"{law(sweep.trend['series'][0]['mean_burst'], sweep.trend)}\n\n")


def other_sweeps(campaign):
    if not campaign.sweeps:
        return ""
    return "## Other keys\n\n" + "".join(map(other_sweep, campaign.sweeps.values()))


def flat(scene, prefix=""):
    """Keys of a scene, each with the name of its section."""
    entries = {}
    for key, value in scene.items():
        entries.update(flat(value, f"{prefix}{key}.") if isinstance(value, dict) else {prefix + key: value})
    return entries


# What differs from point to point of any campaign.
POINTWISE = ("particles.diameter", "particles.roughness", "lubrication.cutoff", "porosity.update_interval", "unclog.after", "unclog.duration",
             "time.end", "ensemble.seeds", "output.")


def condition(here, there):
    """The keys in which another campaign differs, in words."""
    a, b = (flat(tomllib.loads(c.points[0].group["scene"])) for c in (here, there))
    changed = [key for key in sorted(b) if b[key] != a.get(key) and not key.startswith(POINTWISE)]
    # Walls have the friction of the particles unless they are given their own.
    return ", ".join(f"`{key} = {b[key]}`" for key in changed if b[key] != b.get(key.replace("wall_friction", "friction")) or "wall_" not in key)


def beside(campaign, other):
    """<s> of another campaign at the same sizes, and the ratio with its interval."""
    rows = []
    for o in other.points:
        p = next((p for p in campaign.points if abs(o.ratio - p.ratio) < 0.01 * p.ratio), None)
        b = o.trend["mean_burst"]
        ratio = "-"
        if p is not None and b["value"] and p.trend["mean_burst"]["value"]:
            ratio = estimate(over(b, p.trend["mean_burst"]))
        rows.append([number(o.ratio), len(o.group["runs"]), f"{b['stops']} / {b['passages']}", f"**{estimate(b)}**", ratio,
                     estimate(o.quantity("flow_rate_flowing")), number(o.group["steady"]["packing_fraction"]["value"]), number(o.core_hours(), 2)])
    return table(["D/d", "seeds", "clogs / passages", "<s>", "over that of the campaign", "passages per second of flow", "packing", "core-hours"], rows)


def other_verdicts(campaign, other):
    """The claims that are decided otherwise there."""
    same = copy.copy(campaign)  # with the sizes of the other alone: what was not run there decides nothing
    same.points = [p for p in campaign.points if other.at(1e6 * p.group["geometry"]["diameter"])]
    here = {claim: verdict for claim, _, verdict in claims.rows(same)}
    rows = [row for row in claims.rows(other) if row[2] not in (claims.ABSENT, claims.OPEN, here[row[0]])]
    return ("\n\nClaims that are decided otherwise there:\n\n" + table(["claim", "there", "agrees?"], rows)) if rows else ""


def other_campaigns(campaign):
    return "".join(f"## With {condition(campaign, other)}\n\n{beside(campaign, other)}\n\n{law(other.fit['mean_burst'], other.trend)}{other_verdicts(campaign, other)}\n\n"
                   for other in campaign.others)


def missing(campaign):
    sizes = ", ".join(f"{d} um (D/d = {number(100 / d)})" for d in campaign.missing())
    longer = [f"D/d = {number(p.ratio)} in {number(campaign.channel_of(p))} D of straight channel" for p in campaign.points
              if campaign.channel_of(p) != campaign.channel_of(campaign.points[0])]
    said = f"Sizes of the paper without a run: {sizes}." if sizes else "All nine sizes were run."
    return " ".join([said, "D/d = 2.13 (47 um) is run beside 2, where whole layers fit.", *(f"{text}, as in the paper." for text in longer)])


def not_covered(campaign):
    bullets = ["* 3 GPa; noise at these sizes; other flow rates at other sizes than 2.13; other numerics and starts with the friction of 0.1.",
               "* How arches break: needs runs without restarts and with noise ([arches.md](arches.md))."]
    few = [p for p in campaign.points if p.trend["mean_burst"]["stops"] < 100 and p.trend["mean_burst"]["status"] != "lower bound"]
    if few:
        bullets.append("* Fewer than 100 clogs, so <s> to 20 % at best: D/d = " + ", ".join(number(p.ratio) for p in few) + ".")
    return "\n".join(bullets)


def shown(page):
    """The page with <s> as readers shall see it: a viewer takes a tag of that name for text to be struck out, but not in code."""
    return re.sub(r"`[^`]*`|<s>", lambda found: r"\<s>" if found[0] == "<s>" else found[0], page)


def main():
    matplotlib.use("Agg")  # no windows
    work, count = Path(sys.argv[1]), int(sys.argv[2])
    campaign = Campaign(work / "0", [work / str(k) for k in range(1, count)])
    for group in campaign.statistics.groups:  # the page says which point has a longer channel; legends would repeat it at each size
        group["label"] = group["label"].split(", channel_length")[0]
    for module, name, target in ((fig_spatiotemporal, "spatiotemporal_sweep", "figure3.png"), (fig_bursts, "bursts", "figure4.png"),
                                 (fig_lapses, "lapses", "figure5.png")):
        keep_png(dict(module.figures(campaign.statistics))[name], target)
    fit = campaign.fit["mean_burst"]
    head = ["claim", "ours (D/d: value)", "agrees?"]
    page = Template((HERE / "template.md.in").read_text(encoding="utf-8")).substitute(
        summary=summary(campaign), missing=missing(campaign), points=points(campaign), law=law(fit, campaign.trend) + rivals(fit), memory=memory(campaign),
        rewind=rewind(campaign), bias=bias(campaign), order=order(campaign), settling=settling(campaign),
        claims=table(head, claims.rows(campaign)), trends=table(head, trends_of_experiments.rows(campaign)),
        sweeps=other_campaigns(campaign) + other_sweeps(campaign),
        numerics=numerics(campaign.points[0].group),
        arguments=" ".join(["campaign", *(["SWEEP ..."] if count > 1 else [])]), not_covered=not_covered(campaign))
    with rewritten(REPORTS / "results.md") as file:
        file.write(shown(page).rstrip("\n") + "\n")


if __name__ == "__main__":
    main()
