"""One self-contained HTML page: figures embedded, numbers in tables, scene and provenance."""

import base64
import html
import json
from pathlib import Path
from string import Template

import player

RULED_OUT_BELOW = 0.1  # p-value, as Clauset et al.
ROUGH_BELOW = 50       # values in a tail, ibid.

CAPTIONS = {
    "snapshots": "A burst: the arch before it, the burst, and the arch that ends it. Circles are particles seen along z, "
                 "those in front on top, coloured by speed.",
    "spatiotemporal": "Passages through the neck, one row a seed. Each passage is a black bar of width τ = d/v; grey: nothing passes.",
    "spatiotemporal_sweep": "The first seed of every point, as in the paper's figure 3: passages through the neck over the median length of these runs.",
    "necks": "Necks side by side. Left: passages of each with friction on, first seed; grey: a clog of all is cleared without friction, where nothing counts. Right: passages per clog "
             "with 95 % interval over seeds; circles: per clog of all necks at once; squares: per lapse of T_min and more of the neck itself.",
    "bursts": "Burst sizes over their mean, with the counting error. Dashed: geometric law of a memoryless clogging. In a sweep, "
              "right: the mean, first bursts and those cut off by the end included, with its 95 % interval; a triangle stands on the lower bound "
              "of a point without a clog; dashed: fitted law.",
    "first_burst": "Passages until the first clog of a seed. Above: share of the seeds that more than n particles pass (Kaplan-Meier "
                   "with standard error; seeds that the end of the run cut are censored); dashed: geometric law, from "
                   "where on it is not ruled out. Below: chance that the neck clogs before the next passage, ten clogs or more a bin, exact 95 % interval; a "
                   "triangle hangs on an upper bound.",
    "lapses": "a: lapses between passages and the power laws fitted to them (Clauset, Shalizi & Newman); dotted: clog threshold; "
              "lapses below 0.001 τ are not shown. "
              "b: arrests that survive a time (Kaplan-Meier with standard error; arrests cut by a release or by the end of the run are censored). "
              "In a sweep, c: exponent of the arrests with its 95 % interval; open: releases cut the arrests, not fitted; a triangle hangs "
              "on an upper bound; dotted: α = 2; dashed: fitted law.",
    "series": "Number of particles in the domain, packing fraction of the channel and porosity of the strips; the factor q on the flow, and the pressure that drives it, where it is not steady.",
}


class Markup(str):
    """Text that is HTML already; everything else is escaped where it enters a table."""


def escaped(text):
    return text if isinstance(text, Markup) else html.escape(str(text))


def quiet(text):
    return Markup(f"<span class=quiet>{escaped(text)}</span>")


def marked(text, mark):
    return Markup(f'{escaped(text)} <span class="drifts">{escaped(mark)}</span>')


def note(text):
    return Markup(f'<p class="note">{escaped(text)}</p>')


def number(value):
    if value is None:
        return "–"
    return f"{value:.4g}" if isinstance(value, (int, float)) else str(value)


def interval(entry):
    """Value with its interval; where something is not known, a bound or the reason in its place."""
    why = entry.get("note", "")
    low, high = number(entry["low"]), number(entry["high"])
    if entry["value"] is None:
        known = f"< {high} " if entry["high"] is not None else f"> {low} " if entry["low"] is not None else ""
        return Markup(escaped(known) + quiet(why or "unknown"))
    if entry["low"] is None:
        return Markup(f"{escaped(number(entry['value']))} {quiet(why)}")
    return Markup(f"{escaped(number(entry['value']))} {quiet(f'[{low}, {high}]' + (f' {why}' if why else ''))}")


def headline(entry):
    """The same with what stands against it: a law that is ruled out, a run that drifts."""
    text = interval(entry)
    if entry.get("ruled_out"):
        text = marked(text, entry["verdict"])
    elif "verdict" in entry:
        text = Markup(f"{text} {quiet(entry['verdict'])}")
    return marked(text, "drifts: the halves differ") if entry.get("drifts") else text


def table(head, rows):
    cells = "".join(f"<th>{escaped(cell)}</th>" for cell in head)
    body = "".join("<tr>" + "".join(f"<td>{escaped(cell)}</td>" for cell in row) + "</tr>" for row in rows)
    return Markup(f'<div class="scroll"><table><thead><tr>{cells}</tr></thead><tbody>{body}</tbody></table></div>')


NOT_OF_THIS_PROTOCOL = "no release"


def applies(key, groups):
    return any(g["quantities"][key].get("note") != NOT_OF_THIS_PROTOCOL for g in groups)


def memoryless(group):
    """Whether the burst sizes have the law of a memoryless stopping."""
    law = group["bursts"].get("geometric")
    return quiet("no burst that began and ended within a run") if law is None else ruling(law)


def ruling(verdict):
    return marked("", verdict["verdict"]) if verdict["ruled_out"] else verdict["verdict"]


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

    def row(name, cell):
        return [name, *["–" if each is None else cell(each) for each in known]]

    def mean(each):
        entry = each["passage_diameter"]
        in_um = {k: 1e6 * v if isinstance(v, float) else v for k, v in entry.items()}
        return Markup(f"{interval(in_um)} {quiet('of %.4g' % (1e6 * each['feed_diameter']))}")

    rows = [row("mean diameter of passages [µm] (of the feed)", mean)]
    for k in range(max(len(each["species"]) for each in known if each)):
        def share(each, k=k):
            if k >= len(each["species"]):
                return "–"
            kind = each["species"][k]
            return Markup(f"{interval(kind['passage_share'])} {quiet('of %.3g; %.4g µm, %d passages' % (kind['feed_share'], 1e6 * kind['diameter'], kind['passages']))}")
        rows.append(row(f"share of species {k} in the passages (in the feed)", share))
    return rows


def law_of_first(geometric):
    if "tail" not in geometric:
        return ruling(geometric)
    tail = geometric["tail"]
    return Markup(f"{ruling(geometric)} memoryless from {tail['from']} passages on, hazard {interval(tail['hazard'])} "
                  f"{quiet('p = %.2g' % tail['p_value'])}")


def restricted(mean):
    if mean["value"] is None or mean["restricted_to"] is None:
        return interval(mean)
    return Markup(f"{interval(mean)} {quiet('restricted to %d' % mean['restricted_to'])}")


def places(clogs):
    return f"{clogs['upstream']} of {clogs['known']}" if clogs["known"] else quiet(clogs["share_upstream"]["note"])


def summary(groups):
    head = ["", *[group["label"] for group in groups]]
    rows = [["seeds", *[len(g["runs"]) for g in groups]],
            ["simulated time [s]", *[number(sum(r["end"] - r["start"] for r in g["runs"])) for g in groups]],
            ["τ [ms]", *[number(g["tau"] * 1e3) for g in groups]],
            ["clog threshold T_min [ms]", *[number(g["t_min"] * 1e3) for g in groups]],
            ["bursts counted (cut off by the end)", *[f"{g['bursts']['counted']} ({g['bursts']['cut_off']})" for g in groups]],
            ["arrests (cut by a release, by the end)",
             *["{} ({}, {})".format(sum(g["arrests"].values()), g["arrests"]["ended_by_release"],
                                    g["arrests"]["ended_by_end_of_run"]) for g in groups]]]
    for key, entry in groups[0]["quantities"].items():
        if not applies(key, groups):
            continue
        unit = "" if entry["unit"] == "1" else f" [{entry['unit']}]"
        rows.append([entry["meaning"] + unit, *[headline(g["quantities"][key]) for g in groups]])
    rows.append(["geometric law of the burst sizes", *[memoryless(g) for g in groups]])
    rows += first_bursts(groups)
    rows += sizes(groups)
    rows.append(["particles, steady", *[interval(g["steady"]["particles"]) for g in groups]])
    rows.append(["packing fraction, steady", *[interval(g["steady"]["packing_fraction"]) for g in groups]])
    for strip in range(max(len(g["steady"]["porosity"]) for g in groups)):
        rows.append([f"porosity of strip {strip + 1}, steady",
                     *[interval(g["steady"]["porosity"][strip]) if strip < len(g["steady"]["porosity"]) else "–" for g in groups]])
    return table(head, rows) + ('<p class="quiet">In brackets: 95 % bootstrap interval over seeds, unless another is named. '
                               "A law is called ruled out below p = 0.1.</p>")


def necks(groups):
    """What each of several necks let pass, beside all together; nothing where there is one."""
    parts = []
    for group in groups:
        if not group.get("necks"):
            continue
        columns = [*group["necks"], group]
        rows = [["passages (of them while friction was off)",
                 *[f"{sum(r['passages'] for r in c['runs']):d} ({sum(r['while_off'] for r in c['runs']):d})" for c in columns]],
                ["bursts counted (cut off by the end)", *[f"{c['bursts']['counted']} ({c['bursts']['cut_off']})" for c in columns]],
                ["arrests (cut by a release, by the end)",
                 *["{} ({}, {})".format(sum(c["arrests"].values()), c["arrests"]["ended_by_release"], c["arrests"]["ended_by_end_of_run"])
                   for c in columns]],
                ["longest lapse [ms]", *[number(1e3 * c["longest"]) for c in columns]]]
        for key, entry in group["quantities"].items():
            if applies(key, [group]):
                unit = "" if entry["unit"] == "1" else f" [{entry['unit']}]"
                rows.append([entry["meaning"] + unit, *[interval(c["quantities"][key]) for c in columns]])
        title = f"<h3>{escaped(group['label'])}</h3>" if len(groups) > 1 else ""
        parts.append(title + table(["", *[f"neck {k}" for k in range(len(columns) - 1)], "all together"], rows))
    if not parts:
        return ""
    return ("<h2>Each neck</h2>" + "".join(parts) +
            '<p class="quiet">In order of y. Together a clog is one of all necks at once, and a release or restart is of all. '
            "The flow goes on through a clogged neck as through an open one.</p>")


def halves(groups):
    rows = []
    for group in groups:
        for entry in group["quantities"].values():
            if "first_half" not in entry or entry["change"]["value"] is None:
                continue
            change = interval(entry["change"])
            rows.append([f"{group['label']}: {entry['meaning']}", number(entry["first_half"]["value"]),
                         number(entry["second_half"]["value"]), Markup(f'<span class="drifts">{change}</span>') if entry["drifts"] else change])
    return table(["", "first half", "second half", "change"], rows)


def size(n):
    return marked(n, "rough") if n < ROUGH_BELOW else n


def fits(groups):
    names = {"free": "T_min found by the scan", "fixed": "T_min = threshold", "fixed_censored": "T_min = threshold, censored arrests included"}
    rows, refused = [], []
    for group in groups:
        for key, name in names.items():
            fit = group["power_law"][key]
            if "refused" in fit:
                refused.append(f"{group['label']}, {name}: {fit['refused']}")
                continue
            rival = fit["exponential"]
            censored = key == "fixed_censored"
            p = fit.get("p_value")
            rows.append([f"{group['label']}, {name}", f"{fit['alpha']:.3f} ± {fit['sigma']:.3f}",
                         number(group["t_min"] / group["tau"] if censored else fit["xmin_over_tau"]),
                         size(fit["n_complete"] if censored else fit["n_tail"]), number(fit["ks"]),
                         "not tested" if p is None else marked(number(p), "ruled out") if p < RULED_OUT_BELOW else number(p),
                         f"{rival['normalized_ratio']:+.2f} (p = {rival['p_value']:.2g}): {rival['favoured']}"])
    text = table(["", "α", "T_min/τ", "n", "KS distance", "p (power law)", "likelihood ratio to the exponential"], rows) if rows else ""
    text += "".join(note(f"Not fitted: {line}") for line in refused)
    return text + ('<p class="quiet">n: values in the tail; rough: fewer than 50. p: share of power-law samples that lie further from their fit than the data; below 0.1 the '
                   "power law is ruled out. Likelihood ratio: positive favours the power law, negative the exponential; undecided "
                   "when its own p exceeds 0.1.</p>")


def film(statistics, paths):
    """The player, its scripts and style; the still of the same run in its place where it cannot play. Or why there is none."""
    parts, why = player.section(statistics)
    if parts is None:
        return {"film": f'<p class="quiet">{escaped(why)}</p>', "film_style": "", "film_script": ""}, []
    frame, script, style = parts
    still = [path for path in paths if path.stem == "snapshots"]
    if still:
        frame += f'<details class="still" open><summary>Three moments as a picture</summary>{figures(still)}</details>'
    return {"film": f"<h2>A burst</h2>{frame}", "film_style": style, "film_script": script}, still


def figures(paths):
    parts = []
    for path in paths:
        if path.suffix != ".png":
            continue
        caption = CAPTIONS.get(path.stem) or CAPTIONS.get(path.stem.split("_")[0], "")
        data = base64.b64encode(path.read_bytes()).decode()
        parts.append(f'<figure><img alt="{escaped(path.stem)}" src="data:image/png;base64,{data}">'
                     f"<figcaption>{escaped(f'{caption} ({path.name}, {path.stem}.svg)')}</figcaption></figure>")
    return "\n".join(parts)


def bounded(entry):
    bound = {"lower bound": f"> {number(entry['low'])}", "upper bound": f"< {number(entry['high'])}"}
    known = bound.get(entry["status"])
    return known or ("–" if entry["value"] is None else interval(entry))


def law(series, quantity, symbol, labels):
    """A fitted law in a row: x, b, ln A, how well it fits, what was not fitted."""
    fit = series[quantity]
    name = symbol + (f" ({series['label']})" if series["label"] else "")
    if "refused" in fit:
        return [name, fit.get("x", ""), "–", "–", "–", "–", "not fitted: " + fit["refused"]]
    out = [escaped(f"{labels[o['group']]}: {o['status']}") + ("" if "agrees" not in o else ", kept" if o["agrees"] else ", <b>broken</b>")
           for o in fit["left_out"]]
    return [name, fit["x"], interval(fit["b"]), interval(fit["ln_A"]),
            f"{fit['chi_squared']:.3g} / {fit['degrees_of_freedom']} (p = {fit['p_value']:.2g})", number(fit["extra_scatter"]),
            Markup("; ".join(out) or "–")]


def sweep(statistics):
    """The points of a sweep and the laws through them; nothing for a single ensemble."""
    trend = statistics.data.get("trend")
    if trend is None or len(statistics.groups) < 2:
        return ""
    points = []
    for point in trend["points"]:
        mean, alpha = point["mean_burst"], point["alpha"]
        group = statistics.groups[point["group"]]
        ruled_out = alpha["value"] is not None and group["quantities"]["alpha_fixed"].get("ruled_out")
        points.append([group["label"], *[point["values"][k] for k in trend["keys"]],
                       mean["stops"], mean["passages"], bounded(mean), alpha["ended"], alpha["cut"], bounded(alpha),
                       marked(alpha["status"], "power law ruled out") if ruled_out else alpha["status"]])
    head = ["", *trend["keys"], "clogs", "passages", "⟨s⟩", "arrests that ended", "arrests cut", "α", "status of α"]
    laws = [law(series, quantity, symbol, [g["label"] for g in statistics.groups]) for series in trend["series"]
            for quantity, symbol in (("mean_burst", "⟨s⟩ = A exp(b x)"), ("alpha", "α = A exp(b x)"))]
    rivals = [escaped(f"{r['x']}: χ² = {r['chi_squared']:.3g}") for series in trend["series"] for r in series["mean_burst"].get("rivals", [])]
    missing = trend["without_runs"]
    return ("<h2>Along the sweep</h2>" + table(head, points) +
            table(["law", "x", "b", "ln A", "χ² / degrees of freedom", "extra scatter of the logarithm", "not fitted: bound kept or broken"], laws) +
            (f'<p class="quiet">ln⟨s⟩ as a straight line in other variables: {"; ".join(rivals)}.</p>' if rivals else "") +
            '<p class="quiet">Here ⟨s⟩ counts every burst: passages per clog, the first bursts and those that the end cut off '
            "included. Intervals (95 %): the wider of the one over seeds and the exact one of the counts. Weights of the fits: these errors and an "
            "extra scatter, if the law misses the points by more than them.</p>" +
            "".join(note(f"{name}: no runs yet") for name in missing))


def provenance(groups):
    parts = []
    for group in groups:
        parts.append(f"<h3>{escaped(group['label'])}</h3><details><summary>effective scene ({escaped(group['scene_hash'])})</summary>"
                     f"<pre>{escaped(group['scene'])}</pre></details>"
                     f"<details><summary>provenance of the first run</summary>"
                     f"<pre>{escaped(json.dumps(group['provenance'], indent=1))}</pre></details>")
    return "\n".join(parts)


def write(statistics, paths, folder):
    groups = statistics.groups
    template = Template((Path(__file__).parent / "report.html").read_text(encoding="utf-8"))
    notes = [f"{g['label']}: {line}" for g in groups for line in g["notes"]]
    title = groups[0]["label"] if len(groups) == 1 else f"sweep of {len(groups)} scenes"
    parts, shown = film(statistics, [path for path in paths if path.suffix == ".png"])
    page = template.substitute(
        parts, title=escaped(title),
        subtitle=escaped(f"clogflow {statistics.data['program']}, {sum(len(g['runs']) for g in groups)} runs"),
        notes="".join(map(note, notes)),
        summary=summary(groups), necks=necks(groups), sweep=sweep(statistics), figures=figures([path for path in paths if path not in shown]), halves=halves(groups), fits=fits(groups),
        provenance=provenance(groups))
    target = Path(folder) / "report.html"
    target.write_text(page, encoding="utf-8")
    return target
