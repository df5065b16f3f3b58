"""The tables of the page: numbers of all groups, each neck, the sweep, halves, fits, runs."""

from markupsafe import Markup, escape

import run_file
from lengths import unit_of
from page_cells import RULED_OUT_BELOW, Cell, Table, bounded, headline, interval, marked, number, quiet, ruling, size

NOT_OF_THIS_PROTOCOL = "no release"


def applies(key, groups):
    return any(g["quantities"][key].get("note") != NOT_OF_THIS_PROTOCOL for g in groups)


def memoryless(group):
    """Whether the burst sizes have the law of a memoryless stopping."""
    law = group["bursts"].get("geometric")
    return quiet("no burst that began and ended within a run") if law is None else ruling(law)


def first_bursts(groups):
    """One burst a seed, and the packing that they belong to."""
    firsts = [group["first_burst"] for group in groups]
    order = [group["burst_order"] for group in groups]
    rows = [["first bursts: seeds that clogged (cut off by the end)", *[f"{f['clogged']} ({f['cut_off']})" for f in firsts]],
            ["first bursts: mean, of those cut off too", *[restricted(f["mean"]) for f in firsts]],
            ["first bursts: geometric law", *[law_of_first(f["geometric"]) for f in firsts]],
            ["solids near the neck until the last passage of the first burst", *[interval(f["packing_near_neck"]["flowing"]) for f in firsts]],
            ["solids near the neck at its end", *[interval(f["packing_near_neck"]["at_end"]) for f in firsts]],
            ["first clogs more than a neck width upstream of the neck", *[places(f["clog_places"]) for f in firsts]]]
    if any(order):
        rows.append(["later bursts: alike and independent?",
                     *[quiet("too few") if o is None else marked("", o["verdict"]) if o["depends"] else o["verdict"] for o in order]])
    return rows


def sizes(groups):
    """Which particles passed, where they differ."""
    known = [group.get("sizes") for group in groups]
    if not any(known):
        return []

    unit = unit_of(*[each["feed_diameter"] for each in known if each])

    def row(name, cell):
        return [name, *["–" if each is None else cell(each) for each in known]]

    def mean(each):
        entry = each["passage_diameter"]
        shown = {k: unit.per_metre * v if isinstance(v, float) else v for k, v in entry.items()}
        return interval(shown) + " " + quiet(f"of {unit.per_metre * each['feed_diameter']:.4g}")

    rows = [row(f"mean diameter of passages [{unit.name}] (of the feed)", mean)]
    for k in range(max(len(each["species"]) for each in known if each)):
        def share(each, k=k):
            if k >= len(each["species"]):
                return "–"
            kind = each["species"][k]
            return interval(kind["passage_share"]) + " " + quiet(f"of {kind['feed_share']:.3g}; {unit.per_metre * kind['diameter']:.4g} {unit.name}, {kind['passages']} passages")
        rows.append(row(f"share of species {k} in the passages (in the feed)", share))
    return rows


def law_of_first(geometric):
    if "tail" not in geometric:
        return ruling(geometric)
    tail = geometric["tail"]
    return (ruling(geometric) + f" memoryless from {tail['from']} passages on, hazard " + interval(tail["hazard"]) + " " +
            quiet(f"p = {tail['p_value']:.2g}"))


def restricted(mean):
    if mean["value"] is None or mean["restricted_to"] is None:
        return interval(mean)
    return interval(mean) + " " + quiet(f"restricted to {mean['restricted_to']}")


def places(clogs):
    return f"{clogs['upstream']} of {clogs['known']}" if clogs["known"] else quiet(clogs["share_upstream"]["note"])


def counts(part):
    arrests = part["arrests"]
    return [f"{part['bursts']['counted']} ({part['bursts']['cut_off']})",
            f"{sum(arrests.values())} ({arrests['ended_by_release']}, {arrests['ended_by_end_of_run']})"]


def with_unit(entry):
    return entry["meaning"] + ("" if entry["unit"] == "1" else f" [{entry['unit']}]")


def summary(groups):
    rows = [["seeds", *[len(g["runs"]) for g in groups]],
            ["simulated time [s]", *[number(sum(r["end"] - r["start"] for r in g["runs"])) for g in groups]],
            ["τ [ms]", *[number(g["tau"] * 1e3) for g in groups]],
            ["clog threshold T_min [ms]", *[number(g["t_min"] * 1e3) for g in groups]],
            ["bursts counted (cut off by the end)", *[counts(g)[0] for g in groups]],
            ["arrests (cut by a release, by the end)", *[counts(g)[1] for g in groups]]]
    for key, entry in groups[0]["quantities"].items():
        if applies(key, groups):
            rows.append([with_unit(entry), *[headline(g["quantities"][key]) for g in groups]])
    rows.append(["geometric law of the burst sizes", *[memoryless(g) for g in groups]])
    rows += first_bursts(groups)
    rows += sizes(groups)
    rows.append(["particles, steady", *[interval(g["steady"]["particles"]) for g in groups]])
    rows.append(["packing fraction, steady", *[interval(g["steady"]["packing_fraction"]) for g in groups]])
    for strip in range(max(len(g["steady"]["porosity"]) for g in groups)):
        rows.append([f"porosity of strip {strip + 1}, steady",
                     *[interval(g["steady"]["porosity"][strip]) if strip < len(g["steady"]["porosity"]) else "–" for g in groups]])
    return Table("numbers", ["", *[group["label"] for group in groups]], rows,
                 "In brackets: 95 % bootstrap interval over seeds, unless another is named. A law is called ruled out below p = 0.1.")


def necks(groups):
    """What each of several necks let pass, beside all together: (label, table); none where there is one neck."""
    found = []
    for group in groups:
        if not group.get("necks"):
            continue
        columns = [*group["necks"], group]
        rows = [["passages (of them while friction was off)",
                 *[f"{sum(r['passages'] for r in c['runs']):d} ({sum(r['while_off'] for r in c['runs']):d})" for c in columns]],
                ["bursts counted (cut off by the end)", *[counts(c)[0] for c in columns]],
                ["arrests (cut by a release, by the end)", *[counts(c)[1] for c in columns]],
                ["longest lapse [ms]", *[number(1e3 * c["longest"]) for c in columns]]]
        for key, entry in group["quantities"].items():
            if applies(key, [group]):
                rows.append([with_unit(entry), *[interval(c["quantities"][key]) for c in columns]])
        head = ["", *[f"neck {k}" for k in range(len(columns) - 1)], "all together"]
        found.append((group["label"] if len(groups) > 1 else "", Table(f"necks_{groups.index(group)}", head, rows)))
    return found


def around(value, error):
    """1.96 standard errors to both sides."""
    return {"value": value, "low": value - 1.96 * error, "high": value + 1.96 * error}


def halves(groups):
    rows = []
    for group in groups:
        for entry in group["quantities"].values():
            if "first_half" not in entry or entry["change"]["value"] is None:
                continue
            change = interval(entry["change"])
            rows.append([f"{group['label']}: {entry['meaning']}", number(entry["first_half"]["value"]), number(entry["second_half"]["value"]),
                         Cell(Markup('<span class="drifts">{}</span>').format(change), change.value, change.low, change.high) if entry["drifts"] else change])
    return Table("halves", ["", "first half", "second half", "change"], rows)


def fits(groups):
    names = {"free": "T_min found by the scan", "fixed": "T_min = threshold", "fixed_censored": "T_min = threshold, censored arrests included"}
    rows, refused = [], []
    for group in groups:
        for key, name in names.items():
            fit = group["power_law"][key]
            if "refused" in fit:
                refused.append(f"Not fitted: {group['label']}, {name}: {fit['refused']}")
                continue
            rival, censored, p = fit["exponential"], key == "fixed_censored", fit.get("p_value")
            rows.append([f"{group['label']}, {name}", interval(around(fit["alpha"], fit["sigma"])),
                         number(group["t_min"] / group["tau"] if censored else fit["xmin_over_tau"]),
                         size(fit["n_complete"] if censored else fit["n_tail"]), number(fit["ks"]),
                         "not tested" if p is None else marked(number(p), "ruled out") if p < RULED_OUT_BELOW else number(p),
                         f"{rival['normalized_ratio']:+.2f} (p = {rival['p_value']:.2g}): {rival['favoured']}"])
    return Table("fits", ["", "α", "T_min/τ", "n", "KS distance", "p (power law)", "likelihood ratio to the exponential"], rows,
                 "In brackets: 95 % interval, ± 1.96 standard errors. n: values in the tail; rough: fewer than 50. p: share of power-law samples that lie further from their fit than the data; below 0.1 "
                 "the power law is ruled out. Likelihood ratio: positive favours the power law, negative the exponential; undecided when its own p "
                 "exceeds 0.1.", refused)


def law(series, quantity, symbol, labels):
    """A fitted law in a row: x, b, ln A, how well it fits, what was not fitted."""
    fit = series[quantity]
    name = symbol + (f" ({series['label']})" if series["label"] else "")
    if "refused" in fit:
        return [name, fit.get("x", ""), "–", "–", "–", "–", "not fitted: " + fit["refused"]]
    out = [escape(f"{labels[o['group']]}: {o['status']}") + ("" if "agrees" not in o else ", kept" if o["agrees"] else Markup(", <b>broken</b>"))
           for o in fit["left_out"]]
    return [name, fit["x"], interval(fit["b"]), interval(fit["ln_A"]),
            f"{fit['chi_squared']:.3g} / {fit['degrees_of_freedom']} (p = {fit['p_value']:.2g})", number(fit["extra_scatter"]),
            Markup("; ").join(out) or "–"]


def sweep(statistics):
    """The points of a sweep and the laws through them; none for a single ensemble."""
    trend = statistics.data.get("trend")
    if trend is None or len(statistics.groups) < 2:
        return []
    points = []
    for point in trend["points"]:
        mean, alpha = point["mean_burst"], point["alpha"]
        group = statistics.groups[point["group"]]
        ruled_out = alpha["value"] is not None and group["quantities"]["alpha_fixed"].get("ruled_out")
        points.append([group["label"], *[point["values"][k] for k in trend["keys"]],
                       mean["stops"], mean["passages"], bounded(mean), alpha["ended"], alpha["cut"], bounded(alpha),
                       marked(alpha["status"], "power law ruled out") if ruled_out else alpha["status"]])
    laws = [law(series, quantity, symbol, [g["label"] for g in statistics.groups]) for series in trend["series"]
            for quantity, symbol in (("mean_burst", "⟨s⟩ = A exp(b x)"), ("alpha", "α = A exp(b x)"))]
    rivals = [f"{r['x']}: χ² = {r['chi_squared']:.3g}" for series in trend["series"] for r in series["mean_burst"].get("rivals", [])]
    about = ((f"ln⟨s⟩ as a straight line in other variables: {'; '.join(rivals)}. " if rivals else "") +
             "Here ⟨s⟩ counts every burst: passages per clog, the first bursts and those that the end cut off included. Intervals (95 %): the wider of "
             "the one over seeds and the exact one of the counts. Weights of the fits: these errors and an extra scatter, if the law misses the points "
             "by more than them.")
    head = ["", *trend["keys"], "clogs", "passages", "⟨s⟩", "arrests that ended", "arrests cut", "α", "status of α"]
    return [Table("points", head, points),
            Table("laws", ["law", "x", "b", "ln A", "χ² / degrees of freedom", "extra scatter of the logarithm", "not fitted: bound kept or broken"], laws,
                  about, [f"{name}: no runs yet" for name in trend["without_runs"]])]


RECORD = (("program", "program"), ("revision", "revision"), ("compiler", "compiler"), ("instruction set", "instruction_set"), ("host", "host"),
          ("flow", "flow_hash"), ("inputs", "inputs_hash"), ("step [s]", "time_step_s"), ("wall time [s]", "wall_time_s"),
          ("particle-steps/s", "particle_steps_per_s"), ("step over its limits, at the start", "step_limits"))


def runs(groups):
    """Who wrote every run: what all have in common, and a row a run for the rest."""
    records = [(group, entry, run_file.read_record(entry["file"])) for group in groups for entry in group["runs"]]

    def told(value):
        return "" if value is None else number(value)

    columns = {name: [told(record.get(key)) for *_, record in records] for name, key in RECORD}
    common = {name: values[0] for name, values in columns.items() if len(set(values)) == 1}
    differ = [name for name in columns if name not in common]
    rows = [[group["label"], entry["seed"], number(entry["end"] - entry["start"]), *[columns[name][k] for name in differ], entry["file"]]
            for k, (group, entry, _) in enumerate(records)]
    return {name: value for name, value in common.items() if value}, Table("runs", ["", "seed", "simulated [s]", *differ, "file"], rows)
