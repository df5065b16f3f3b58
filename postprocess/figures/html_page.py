"""One self-contained HTML page: figures embedded, numbers in tables, scene and provenance."""

import base64
import html
import json
from pathlib import Path
from string import Template

CAPTIONS = {
    "snapshots": "A burst: the arch before it, the burst, and the arch that ends it. Circles are particles seen along z, "
                 "those in front on top, coloured by speed.",
    "spatiotemporal": "Passages through the neck, one row a seed. Each passage is a black bar of width τ = d/v; grey: nothing passes.",
    "spatiotemporal_sweep": "The first seed of every point, as in the paper's figure 3: passages through the neck over the median length of these runs.",
    "bursts": "Burst sizes over their mean, with the counting error. Dashed: exponential law of a memoryless clogging. In a sweep, "
              "right: the mean, first bursts and those cut off by the end included, with its 95 % interval; a triangle stands on the lower bound "
              "of a point without a clog; dashed: fitted law.",
    "lapses": "a: lapses between passages and the power laws fitted to them (Clauset, Shalizi & Newman); dotted: clog threshold; "
              "lapses below 0.001 τ are not shown. "
              "b: arrests that survive a time (Kaplan-Meier with standard error; arrests cut by a release or by the end of the run are censored). "
              "In a sweep, c: exponent of the arrests with its 95 % interval; open: releases cut the arrests, not fitted; a triangle hangs "
              "on an upper bound; dotted: α = 2; dashed: fitted law.",
    "series": "Number of particles in the domain, packing fraction of the channel and porosity of the strips.",
}


def number(value):
    return "–" if value is None else f"{value:.4g}"


def interval(entry):
    if entry["value"] is None:
        return "–"
    if entry["low"] is None:
        return number(entry["value"])
    return f"{number(entry['value'])} <span class=quiet>[{number(entry['low'])}, {number(entry['high'])}]</span>"


def table(head, rows):
    cells = "".join(f"<th>{cell}</th>" for cell in head)
    body = "".join("<tr>" + "".join(f"<td>{cell}</td>" for cell in row) + "</tr>" for row in rows)
    return f'<div class="scroll"><table><thead><tr>{cells}</tr></thead><tbody>{body}</tbody></table></div>'


def summary(groups):
    head = ["", *[html.escape(group["label"]) for group in groups]]
    rows = [["seeds", *[len(g["runs"]) for g in groups]],
            ["simulated time [s]", *[number(sum(r["end"] - r["start"] for r in g["runs"])) for g in groups]],
            ["τ [ms]", *[number(g["tau"] * 1e3) for g in groups]],
            ["clog threshold T_min [ms]", *[number(g["t_min"] * 1e3) for g in groups]],
            ["bursts counted (cut off by the end)", *[f"{g['bursts']['counted']} ({g['bursts']['cut_off']})" for g in groups]],
            ["arrests (cut by a release, by the end)",
             *["{} ({}, {})".format(sum(g["arrests"].values()), g["arrests"]["ended_by_release"],
                                    g["arrests"]["ended_by_end_of_run"]) for g in groups]]]
    for key, entry in groups[0]["quantities"].items():
        if all(g["quantities"][key]["value"] is None for g in groups):
            continue
        unit = "" if entry["unit"] == "1" else f" [{entry['unit']}]"
        rows.append([html.escape(entry["meaning"]) + unit, *[interval(g["quantities"][key]) for g in groups]])
    rows.append(["particles, steady", *[interval(g["steady"]["particles"]) for g in groups]])
    rows.append(["packing fraction, steady", *[interval(g["steady"]["packing_fraction"]) for g in groups]])
    for strip in range(max(len(g["steady"]["porosity"]) for g in groups)):
        rows.append([f"porosity of strip {strip + 1}, steady",
                     *[interval(g["steady"]["porosity"][strip]) if strip < len(g["steady"]["porosity"]) else "–" for g in groups]])
    return table(head, rows) + '<p class="quiet">In brackets: 95 % bootstrap interval over seeds.</p>'


def halves(groups):
    rows = []
    for group in groups:
        for entry in group["quantities"].values():
            if "first_half" not in entry or entry["change"]["value"] is None:
                continue
            change = interval(entry["change"])
            rows.append([html.escape(f"{group['label']}: {entry['meaning']}"), number(entry["first_half"]["value"]),
                         number(entry["second_half"]["value"]), f'<span class="ages">{change}</span>' if entry["ages"] else change])
    return table(["", "first half", "second half", "change"], rows)


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
            rows.append([html.escape(f"{group['label']}, {name}"), f"{fit['alpha']:.3f} ± {fit['sigma']:.3f}",
                         number(fit.get("xmin_over_tau", group["t_min"] / group["tau"])),
                         fit.get("n_tail", fit.get("n_complete")), number(fit.get("ks")), number(fit.get("p_value")),
                         f"{rival['normalized_ratio']:+.2f} (p = {rival['p_value']:.2g}): {rival['favoured']}"])
    text = table(["", "α", "T_min/τ", "n", "KS distance", "p (power law)", "likelihood ratio to the exponential"], rows) if rows else ""
    text += "".join(f'<p class="note">Not fitted: {html.escape(line)}</p>' for line in refused)
    return text + ('<p class="quiet">p: share of power-law samples that lie further from their fit than the data; below 0.1 the '
                   "power law is ruled out. Likelihood ratio: positive favours the power law, negative the exponential; undecided "
                   "when its own p exceeds 0.1.</p>")


def figures(paths):
    parts = []
    for path in paths:
        if path.suffix != ".png":
            continue
        caption = CAPTIONS.get(path.stem) or CAPTIONS.get(path.stem.split("_")[0], "")
        data = base64.b64encode(path.read_bytes()).decode()
        parts.append(f'<figure><img alt="{path.stem}" src="data:image/png;base64,{data}">'
                     f"<figcaption>{html.escape(caption)} ({path.name}, {path.stem}.svg)</figcaption></figure>")
    return "\n".join(parts)


def bounded(entry):
    bound = {"lower bound": f"> {number(entry['low'])}", "upper bound": f"< {number(entry['high'])}"}
    return bound.get(entry["status"], interval(entry))


def law(series, quantity, symbol, labels):
    """A fitted law in a row: x, b, ln A, how well it fits, what was not fitted."""
    fit = series[quantity]
    name = symbol + (f" ({html.escape(series['label'])})" if series["label"] else "")
    if "refused" in fit:
        return [name, html.escape(fit.get("x", "")), "–", "–", "–", "–", "not fitted: " + html.escape(fit["refused"])]
    out = [f"{html.escape(labels[o['group']])}: {o['status']}" + ("" if "agrees" not in o else ", kept" if o["agrees"] else ", <b>broken</b>")
           for o in fit["left_out"]]
    return [name, html.escape(fit["x"]), interval(fit["b"]), interval(fit["ln_A"]),
            f"{fit['chi_squared']:.3g} / {fit['degrees_of_freedom']} (p = {fit['p_value']:.2g})", number(fit["extra_scatter"]),
            "; ".join(out) or "–"]


def sweep(statistics):
    """The points of a sweep and the laws through them; nothing for a single ensemble."""
    trend = statistics.data.get("trend")
    if trend is None or len(statistics.groups) < 2:
        return ""
    points = []
    for point in trend["points"]:
        mean, alpha = point["mean_burst"], point["alpha"]
        points.append([html.escape(statistics.groups[point["group"]]["label"]), *[html.escape(point["values"][k]) for k in trend["keys"]],
                       mean["stops"], mean["passages"], bounded(mean), alpha["ended"], alpha["cut"], bounded(alpha), alpha["status"]])
    head = ["", *map(html.escape, trend["keys"]), "clogs", "passages", "⟨s⟩", "arrests that ended", "arrests cut", "α", "status of α"]
    laws = [law(series, quantity, symbol, [g["label"] for g in statistics.groups]) for series in trend["series"]
            for quantity, symbol in (("mean_burst", "⟨s⟩ = A exp(b x)"), ("alpha", "α = A exp(b x)"))]
    rivals = [f"{html.escape(r['x'])}: χ² = {r['chi_squared']:.3g}" for series in trend["series"] for r in series["mean_burst"].get("rivals", [])]
    missing = trend.get("without_runs", [])
    return ("<h2>Along the sweep</h2>" + table(head, points) +
            table(["law", "x", "b", "ln A", "χ² / degrees of freedom", "extra scatter of the logarithm", "not fitted: bound kept or broken"], laws) +
            (f'<p class="quiet">ln⟨s⟩ as a straight line in other variables: {"; ".join(rivals)}.</p>' if rivals else "") +
            '<p class="quiet">Here ⟨s⟩ counts every burst: passages per clog, the first bursts and those that the end cut off '
            "included. Intervals (95 %): the wider of the one over seeds and the exact one of the counts. Weights of the fits: these errors and an "
            "extra scatter, if the law misses the points by more than them.</p>" +
            "".join(f'<p class="note">{html.escape(name)}: no runs yet</p>' for name in missing))


def provenance(groups):
    parts = []
    for group in groups:
        parts.append(f"<h3>{html.escape(group['label'])}</h3><details><summary>effective scene ({group['scene_hash']})</summary>"
                     f"<pre>{html.escape(group['scene'])}</pre></details>"
                     f"<details><summary>provenance of the first run</summary>"
                     f"<pre>{html.escape(json.dumps(group['provenance'], indent=1))}</pre></details>")
    return "\n".join(parts)


def write(statistics, paths, folder):
    groups = statistics.groups
    template = Template((Path(__file__).parent / "report.html").read_text(encoding="utf-8"))
    notes = [f"{g['label']}: {note}" for g in groups for note in g["notes"]]
    title = groups[0]["label"] if len(groups) == 1 else f"sweep of {len(groups)} scenes"
    page = template.substitute(
        title=html.escape(title),
        subtitle=f"clogflow {statistics.data['program']}, {sum(len(g['runs']) for g in groups)} runs",
        notes="".join(f'<p class="note">{html.escape(note)}</p>' for note in notes),
        summary=summary(groups), sweep=sweep(statistics), figures=figures(paths), halves=halves(groups), fits=fits(groups),
        provenance=provenance(groups))
    target = Path(folder) / "report.html"
    target.write_text(page, encoding="utf-8")
    return target
