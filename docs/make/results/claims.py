"""Every claim of the paper beside ours: (claim, ours, verdict), computed from the campaign where it can be."""

import math

from campaign import NECK_UM, estimate, number, over

AGREES, PARTLY, DIFFERS, OPEN, ABSENT = "agrees", "partly", "**differs**", "cannot be said", "not run"


def listed(points, text):
    return "; ".join(f"{number(p.ratio)}: {text(p)}" for p in points) or "-"


def p_value(p):
    """As far as the replicates of `clog stats` can tell: 250 of them."""
    return "< 0.004" if p == 0 else number(p, 2)


def rises(values):
    """Whether each value exceeds the one before it."""
    return all(a < b for a, b in zip(values, values[1:]))


def permanent_clogs(campaign):
    points = [p for p in campaign.points if p.ratio < 1.5]
    if not points:
        return "-", ABSENT
    first = [sum(p.first_sizes) / len(p.first_sizes) for p in points]
    empty = [p.quantity("share_failed")["value"] or 0 for p in points]
    ours = "; ".join(f"{number(p.ratio)}: {number(n)} particles before the first clog, then {100 * e:.3g} % of the restarts let nothing pass"
                     for p, n, e in zip(points, first, empty)) + ". It stands without friction too ([friction.md](friction.md))"
    few, lasting = all(f < 20 for f in first), all(e > 0.5 for e in empty)
    return ours, AGREES if few and lasting else PARTLY if few or lasting else DIFFERS


def restarts(campaign):
    points = [p for p in campaign.with_clogs() if p.ratio >= 1.99]
    if not points:
        return "-", ABSENT
    ours = ("share of the arrests of tau/2 and more that are permanent: " +
            listed(points, lambda p: f"{100 * p.quantity('share_censored')['value']:.0f} %") +
            ". In steady flow arches of this friction stand for ever ([arches.md](arches.md))")
    # In the paper none is: every clog from D/d = 2 on ends by itself.
    return ours, DIFFERS if all(p.quantity("share_censored")["value"] > 0.1 for p in points) else PARTLY


def longer_flow(campaign):
    points = campaign.with_clogs()
    if len(points) < 3:
        return "-", ABSENT
    values = [p.trend["mean_burst"]["value"] for p in points]
    return "<s>: " + listed(points, lambda p: estimate(p.trend["mean_burst"])), AGREES if rises(values) else PARTLY


def continuous(campaign):
    point = next((c.at(10) for c in (campaign, *campaign.others) if c.at(10)), None)
    if point is None:
        return "-", ABSENT
    arrests = point.trend["alpha"]
    count = arrests["ended"] + arrests["cut"]
    time = sum(r["end"] - r["start"] for r in point.group["runs"])
    length = campaign.channel_of(point)
    return (f"{count} lapses of tau/2 and more in {number(time)} s with {point.trend['mean_burst']['passages']} passages "
            f"({len(point.group['runs'])} run, channel of {number(length)} D, filled to {number(point.group['steady']['packing_fraction']['value'], 2)}): "
            f"<s> {estimate(point.trend['mean_burst'])}. From a filled start such a column stood still ([friction.md](friction.md#what-the-paper-and-the-experiments-see))"), PARTLY


def intermittent_range(campaign):
    expected = [p for p in campaign.points if 1.4 < p.ratio < 4.6]
    clogged = campaign.with_clogs()
    if not expected:
        return "-", ABSENT
    ours = "bursts and clogs at D/d = " + ", ".join(number(p.ratio) for p in clogged)
    # Bursts and clogs follow each other in the paper by themselves, here because the protocol ends every clog.
    return (ours + ", but no clog ended by itself; nothing lies between 4.55 and 10, in the paper neither",
            PARTLY if all(p in clogged or p.ratio < 1.5 for p in expected) else DIFFERS)


def threshold(campaign):
    fits = [(p, p.group["power_law"]["free"]) for p in campaign.points if 1.99 <= p.ratio <= 4.6]
    fits = [(p, f) for p, f in fits if "refused" not in f]
    if not fits:
        return "-", ABSENT
    near = [0.4 <= f["xmin_over_tau"] <= 0.6 for _, f in fits]
    ours = "T_min/tau found by the scan: " + "; ".join(f"{number(p.ratio)}: {number(f['xmin_over_tau'], 2)}" for p, f in fits)
    return ours, AGREES if all(near) else PARTLY if any(near) else DIFFERS


def exponential_sizes(campaign):
    points = [p for p in campaign.points if p.bursts["counted"] >= 20]
    if not points:
        return "fewer than 20 bursts at every size", OPEN
    fits = [p.bursts["geometric"]["p_value"] >= 0.05 for p in points]
    ours = ("p of a geometric law, and standard deviation over that law's: " +
            listed(points, lambda p: f"{p_value(p.bursts['geometric']['p_value'])}, {number(p.bursts['standard_deviation'] / p.bursts['standard_deviation_geometric'], 2)}"
                   if p.bursts["standard_deviation_geometric"] > 0 else "-"))
    return ours, AGREES if all(fits) else PARTLY if any(fits) else DIFFERS


def small_bursts(campaign):
    points = [p for p in campaign.points if p.ratio > 2.9 and p.bursts["counted"] >= 20]
    if not points:
        return "fewer than 20 bursts at D/d >= 3", OPEN

    def excess(p):
        expected, n = p.bursts["share_up_to_3_geometric"], p.bursts["counted"]
        return (p.bursts["share_up_to_3"] - expected) / (expected * (1 - expected) / n) ** 0.5

    ours = "share of s <= 3, of a geometric law with the same mean, excess in standard errors: " + listed(
        points, lambda p: f"{number(p.bursts['share_up_to_3'], 2)}, {number(p.bursts['share_up_to_3_geometric'], 2)}, {excess(p):+.1f}")
    seen = [excess(p) > 2 for p in points]
    return ours, AGREES if all(seen) else PARTLY if any(seen) else DIFFERS


def exponential_mean(campaign):
    fit = campaign.fit["mean_burst"]
    if "refused" in fit:
        return fit["refused"], OPEN
    rivals = "; ".join(f"{r['x']}: {number(r['chi_squared'])}" for r in fit["rivals"])
    ours = (f"b = {estimate(fit['b'])}, not 1 (the literal law would be <s> = e^94 at 4.55); chi squared {number(fit['chi_squared'])} with "
            f"{fit['degrees_of_freedom']} degrees of freedom, p = {number(fit['p_value'], 2)}; ln<s> against other variables: {rivals}")
    best = min(fit["rivals"], key=lambda r: r["chi_squared"])["x"] == "(D/d)^3"
    return ours, AGREES if fit["p_value"] > 0.05 else PARTLY if best else DIFFERS


def few_to_thousands(campaign):
    low, high = campaign.at(70), campaign.at(22)
    if low is None or high is None:
        return "-", ABSENT
    few, many = low.trend["mean_burst"], high.trend["mean_burst"]
    top = many["high"] if many["high"] is not None else float("inf")
    return f"{estimate(few)} at 1.43, {estimate(many)} at 4.55", AGREES if top >= 1000 and few["value"] < 10 else PARTLY


def packing(campaign):
    rows = [(p, n, phi) for p, n, phi in ((campaign.at(33), 1000, 0.5), (campaign.at(80), 60, 0.4)) if p is not None]
    if not rows:
        return "-", ABSENT
    steady = [(p, p.group["steady"]["packing_fraction"]["value"], p.group["steady"]["particles"]["value"]) for p, _, _ in rows]
    length = campaign.channel_of(rows[0][0])
    ours = "; ".join(f"{number(p.ratio)}: {number(phi, 2)}, {number(n)} particles" for p, phi, n in steady) + f" (a column that flows, in {number(length)} D of channel; the paper's 10)"
    close = [abs(phi / claimed - 1) < 0.15 for (_, phi, _), (_, _, claimed) in zip(steady, rows)]
    return ours, AGREES if all(close) else PARTLY if any(close) else DIFFERS


def events(campaign):
    points = campaign.points
    ours = listed(points, lambda p: p.trend["mean_burst"]["stops"])
    enough = all(p.trend["mean_burst"]["stops"] >= 1000 for p in points if 1.99 <= p.ratio < 5)
    blocked = next((p for p in points if 1.4 < p.ratio < 1.5), None)
    if enough and blocked is not None and blocked.trend["mean_burst"]["stops"] < 150:
        return ours + "; how many is a matter of the length of the runs, but at 1.43 nearly all restarts let nothing pass", PARTLY
    return ours, AGREES if enough else "fewer here"


def alpha(campaign):
    points = [p for p in campaign.with_clogs() if p.trend["alpha"]["status"] == "cut by releases"]
    ours = ("from tau/2 to the proof that a clog lasts: " + listed(points, lambda p: estimate(p.trend["alpha"])) +
            ". Longer arrests exist under noise only: [arches.md](arches.md)")
    return ours, OPEN


def along(sweep):
    return "; ".join(f"{value}: {estimate(p['mean_burst'])}" for value, p in zip(sweep.values(), sweep.points))


def changes_nothing(key):
    """A claim that <s> does not depend on a key: the largest step between two values, and whether chance makes as much."""
    def judge(campaign):
        sweep = campaign.sweeps.get(key)
        if sweep is None:
            return "-", ABSENT
        chi_squared, freedom = sweep.chi_squared()
        # Wilson & Hilferty's cube root of chi squared is normal.
        width = 2 / (9 * freedom)
        p = 0.5 * math.erfc(((chi_squared / freedom) ** (1 / 3) - 1 + width) / math.sqrt(2 * width))
        return (f"<s> at D/d = {number(sweep.ratio)}: {along(sweep)}; p of equality {number(p, 2)}",
                AGREES if p > 0.05 else DIFFERS)
    return judge


def longer_channel(campaign):
    """The paper compared lengths with its own of 10 D: shorter ones alone cannot say that it is right."""
    ours, verdict = changes_nothing("geometry.channel_length")(campaign)
    sweep = campaign.sweeps.get("geometry.channel_length")
    if sweep is None or any(p["x"] > 10.5e-6 * NECK_UM for p in sweep.points):
        return ours, verdict
    return ours + "; longer ones than 10 D were not run", OPEN if verdict == AGREES else verdict


def more_strips(campaign):
    """The paper has three and says what more of them do: little, if <s> stays within a tenth with 95 %."""
    ours, verdict = changes_nothing("porosity.strips")(campaign)
    sweep = campaign.sweeps.get("porosity.strips")
    three = next((p["mean_burst"] for p in sweep.points if p["x"] == 3), None) if sweep else None
    if three is None:
        return ours, verdict
    more = over(sweep.points[-1]["mean_burst"], three)
    return (f"{ours}; from three on {estimate(more)} times",
            AGREES if 0.9 < more["low"] and more["high"] < 1.1 else DIFFERS if more["low"] > 1.1 or more["high"] < 0.9 else PARTLY)


def rolling_stabilises(campaign):
    sweep = campaign.sweeps.get("contact.friction.rolling")
    if sweep is None:
        return "-", ABSENT
    lasting = [g["quantities"]["share_censored"]["value"] for g in sweep.groups]
    ours = (f"<s> at D/d = {number(sweep.ratio)} and rolling friction {along(sweep)}; share of the arrests that are permanent: " +
            "; ".join(f"{value}: {100 * share:.0f} %" for value, share in zip(sweep.values(), lasting)))
    first, last = sweep.points[0]["mean_burst"], sweep.points[-1]["mean_burst"]
    return ours, AGREES if last["high"] < first["low"] else PARTLY


FROM_PAPER = [
    ("D/d = 1.25 and 1.43: few particles pass, then a permanent clog (fig. 3)", permanent_clogs),
    ("D/d >= 2: clogs break by themselves, flow goes on in bursts (fig. 3)", restarts),
    ("flowing intervals grow with D/d (fig. 3)", longer_flow),
    ("D/d = 10: continuous, no lapse above tau/2", continuous),
    ("intermittent for 1.43 <= D/d <= 4.55", intermittent_range),
    ("the scan of Clauset et al. finds T_min = 0.5 +- 0.1 tau for 2 <= D/d <= 4.55 (app. B)", threshold),
    ("P(s/<s>) is exponential and the same for all D/d (fig. 4)", exponential_sizes),
    ("more bursts of 1 to 3 particles than that, in three dimensions (fig. 4)", small_bursts),
    ("<s> grows as exp((D/d)^3) (fig. 4)", exponential_mean),
    ("<s> is a few at 1.43, thousands at 4.55 (fig. 4)", few_to_thousands),
    ("arrests have a power-law tail with alpha > 2 for D/d >= 2 (fig. 5)", alpha),
    ("alpha grows with D/d, as exp(0.5 D/d) (fig. 5)", lambda c: ("not measurable with restarts; under a random drag of one strength it grows with D/d, under a pulsation of the flow it does not: [arches.md](arches.md)", OPEN)),
    ("lapses reach 100 tau", lambda c: ("a clog ends a burst as soon as it is proved to last; under noise they occur: [arches.md](arches.md)", OPEN)),
    ("<s> is smaller and alpha larger than in the experiments", lambda c: ("no table of the experiments' values was at hand", OPEN)),
    ("packing 0.5 with about 1000 particles at 3.03; 0.4 with about 60 at 1.25", packing),
    ("more than 1000 bursts for D/d >= 2, about 150 at 1.43", events),
    ("a channel of 15 D or 20 D changes nothing", longer_channel),
    ("more strips of porosity change little", more_strips),
    ("more rolling friction would stabilise arches (a guess of the paper)", rolling_stabilises),
]


def rows(campaign):
    return [(claim, *judge(campaign)) for claim, judge in FROM_PAPER]


def clogs_above_three(campaign):
    points = [p for p in campaign.with_clogs() if p.ratio > 3.1]
    if not points:
        return "-", ABSENT
    return ("bursts that a clog ended: " + listed(points, lambda p: p.trend["mean_burst"]["stops"]) +
            "; sliding friction is 0.6 here, and the authors of that experiment blame low friction"), DIFFERS
