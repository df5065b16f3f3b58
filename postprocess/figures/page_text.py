"""What the page says in words: the runs in one sentence, three numbers, methods, the flow's error, how to cite and to repeat."""

import json
import re
import tomllib

import h5py

from lengths import unit_of

AFTER_A_CLOG = {"none": "a clog is left to itself", "release": "a clog is cleared by a moment without friction", "stop": "a run ends at its first clog",
                "restart": "after a clog the column flows without friction and starts anew",
                "rewind": "after a clog the column goes back to where friction began and flows on from there without friction for a while", "poke": "the arch of a clog is taken out"}
DIGITS = 3


def scene_of(group):
    """Of the effective scene; nothing where another program wrote one that is no TOML."""
    try:
        return tomllib.loads(group["scene"])
    except tomllib.TOMLDecodeError:
        return {}


def span(values, scale, unit):
    """33 mm/s, or 22 to 47 mm/s"""
    low, high = (f"{scale * v:.{DIGITS}g}" for v in (min(values), max(values)))
    text = low if low == high else f"{low} to {high}"
    return f"{text} {unit}".strip()


def span_of_lengths(values):
    unit = unit_of(*values)
    return span(values, unit.per_metre, unit.name)


def through(shape):
    if not shape["present"]:
        return ""
    unit = unit_of(shape["neck_width"])
    width, height = (unit.per_metre * shape[side] for side in ("neck_width", "neck_height"))
    return f" through a neck of {width:.4g} {unit.name}" + (f" × {height:.4g} {unit.name}" if height > 0 else "")


def sentence(statistics):
    groups = statistics.groups
    shapes = [g["geometry"] for g in groups]
    runs = [r for g in groups for r in g["runs"]]
    ratios = [s["neck_ratio"] for s in shapes if "neck_ratio" in s]
    who = f"Spheres of {span_of_lengths([s['diameter'] for s in shapes])}" + (f" (D/d = {span(ratios, 1, '')})" if ratios else "")
    speeds = [s["mean_velocity"] for s in shapes]
    how = f" driven by a flow of {span(speeds, 1e3, 'mm/s')}" if max(speeds) > 0 else ""
    swept = statistics.data.get("trend", {}).get("keys", []) if len(groups) > 1 else []
    points = f"{len(groups)} points of a sweep of {' and '.join(swept)}, " if swept else f"{len(groups)} scenes, " if len(groups) > 1 else ""
    seeds = "1 run" if len(runs) == 1 else f"{len(runs)} runs"
    time = sum(r["end"] - r["start"] for r in runs)
    protocols = {g["protocol"] for g in groups}
    after = f"; {AFTER_A_CLOG[protocols.pop()]}" if len(protocols) == 1 and protocols <= AFTER_A_CLOG.keys() else ""
    return f"{who}{how}{through(shapes[0])}: {points}{seeds}, {time:.{DIGITS}g} s simulated{after}."


def kind_of(entry):
    """In which way its interval was found, as the statistics say it."""
    return entry.get("note") or "bootstrap over seeds"


def short(value):
    return f"{value:.{DIGITS}g}"


def card(label, entry, against="", unit=""):
    """One of the three numbers: value, its interval and its kind, what it means, what stands against it."""
    value, low, high = entry["value"], entry["low"], entry["high"]
    if value is None:
        shown = f"< {short(high)}" if high is not None else f"> {short(low)}" if low is not None else "unknown"
        return {"value": shown, "unit": unit if shown != "unknown" else "", "interval": entry.get("note", ""), "label": label, "against": against}
    known = f"95 % interval {short(low)} to {short(high)} ({kind_of(entry)})" if low is not None else entry.get("note", "no interval")
    return {"value": short(value), "unit": unit, "interval": known, "label": label, "against": against}


def against(entry):
    said = [entry["verdict"]] if entry.get("ruled_out") else []
    return "; ".join(said + (["drifts: the halves of the runs differ"] if entry.get("drifts") else []))


def three_of_group(group):
    quantities, first = group["quantities"], group["first_burst"]

    def of(key, label, unit=""):
        return card(label, quantities[key], against(quantities[key]), unit)

    if group["protocol"] == "stop":
        law = first["geometric"]["verdict"] if first["geometric"]["ruled_out"] else ""
        return [card("mean number of passages until the first clog, seeds that never clogged included", first["mean"]),
                of("share_permanent", f"share of the {first['seeds']} seeds that clogged"),
                card("chance that the neck clogs before the next passage, if it never changed", quantities["first_burst_hazard"],
                     f"geometric law: {law}" if law else "")]
    burst = ("mean_burst", "mean burst: passages between two clogs")
    if group["protocol"] == "none" and quantities["mean_burst"]["value"] is None:
        burst = ("mean_burst_by_threshold", "passages per lapse that counts as a clog")
    left = quantities["alpha_fixed"]
    third = (("alpha_fixed", "power-law exponent α of the arrests; below 2 their mean diverges") if group["protocol"] == "none" and left["value"] is not None
             else ("share_clogged", "share of the time in which nothing passes for T_min and more"))
    return [of(*burst), of("flow_rate", "passages per second, clogs included", "1/s"), of(*third)]


def of_point(point, statistics):
    mean, label = dict(point["mean_burst"]), statistics.groups[point["group"]]["label"]
    if mean["status"] not in ("measured", "mostly empty"):
        mean["value"] = None
    mean["note"] = {"lower bound": "95 % lower bound: no clog", "mostly empty": "mostly empty: more than half of the releases let nothing pass", "measured": "the wider of bootstrap over seeds and exact counts"}.get(mean["status"], mean["status"])
    return card(f"passages per clog ⟨s⟩ at {label}, {mean['stops']} clogs", mean)


def three_of_sweep(statistics):
    trend = statistics.data["trend"]
    points = sorted((p for p in trend["points"] if p["mean_burst"]["low"] is not None or p["mean_burst"]["value"] is not None), key=lambda p: p["x"])
    cards = [of_point(p, statistics) for p in (points[:1] + points[1:][-1:])]
    fit = trend["series"][0]["mean_burst"]
    if "refused" not in fit:
        misfit = f"the law misses the points: p = {fit['p_value']:.1g}" if fit["p_value"] <= 0.05 else ""
        label = f"slope b of ⟨s⟩ = A exp(b x), x = {fit['x'].replace('^3', '³')}" + (f", {trend['series'][0]['label']}" if trend["series"][0]["label"] else "")
        cards.append(card(label, {"note": "of the weighted fit", **fit["b"]}, misfit))
    return cards


def three_numbers(statistics):
    groups = statistics.groups
    return three_of_group(groups[0]) if len(groups) == 1 or "trend" not in statistics.data else three_of_sweep(statistics)


def read_flow(path):
    """(hash, record) of a flow file."""
    with h5py.File(path, "r") as file:
        return file["provenance/hash"][()].decode(), json.loads(file["provenance/record"][()].decode())


def percent(share):
    return f"{100 * share:.2g} %"


def flow_error(statistics, file):
    """[(what, how large)] of the flow file; refuses one that is not of these runs."""
    hashes = {g["provenance"].get("flow_hash") for g in statistics.groups} - {None}
    if not file:
        return [], ("These runs have no flow." if not hashes else
                    f"The error of the flow ({', '.join(sorted(hashes))}) is in its file: clog report DIR --flow flow.h5 tells it here.")
    name, record = read_flow(file)
    scaled = any(scene_of(g).get("flow", {}).get("rescale") for g in statistics.groups)
    if name not in hashes and not scaled:
        raise SystemExit(f"{file}: not the flow of these runs (hash {name}; theirs is {', '.join(sorted(hashes)) or 'none'})")
    rows = [("hash", name), ("OpenFOAM", f"{record.get('openfoam_version', '?')}, {record.get('cells', 0):,} cells, {record.get('iterations', 0):.0f} iterations")]
    mesh, reading = record.get("mesh_error"), record.get("lookup_error")
    if mesh:
        cells = " and ".join(f"{c:.3g}" for c in mesh["cells_per_neck"])
        rows += [("two meshes, cells per neck", cells + (", velocities extrapolated from both" if mesh.get("extrapolated") else "")),
                 ("error of the velocity, of the neck's mean velocity", f"{percent(mesh['velocity_rms'])} root mean square, {percent(mesh['velocity_99_percent'])} at 99 % of the points"),
                 ("error of the pressure drop", percent(abs(mesh["pressure_drop"])))]
    else:
        rows.append(("error of the velocity", "unknown: solved on one mesh (flow.extrapolate)"))
    if record.get("grid_flux_largest_error") is not None:
        rows.append(("largest error of the flow rate through a plane of the grid", percent(abs(record["grid_flux_largest_error"]))))
    if reading:
        rows.append(("what reading the grid adds in the neck, of its mean velocity", f"{percent(reading['nearest_in_neck'])} nearest point, {percent(reading['trilinear_in_neck'])} trilinear"))
    if name not in hashes:
        rows.append(("scaled from this flow to the rate of each scene (flow.rescale)", ", ".join(sorted(hashes))))
    if record.get("rescaled"):
        rows.append(("scaled from another flow rate", f"by {record['rescaled']['factor']:.4g}, which leaves out {percent(record['rescaled']['error'])}"))
    return rows, ""


def seeds_of(group):
    """1-8, or 1-3,7"""
    seeds, parts = sorted(r["seed"] for r in group["runs"]), []
    for seed in seeds:
        if parts and seed == parts[-1][1] + 1:
            parts[-1][1] = seed
        else:
            parts.append([seed, seed])
    return ",".join(f"{a}" if a == b else f"{a}-{b}" for a, b in parts)


def methods(statistics, common):
    """A paragraph that can be pasted."""
    group = statistics.groups[0]
    scene, shape = scene_of(group), group["geometry"]

    def given(section, key, otherwise=None):
        value = scene.get(section, {}).get(key, otherwise)
        if not isinstance(value, str):
            return value
        return re.sub(r"\d+\.\d{7,}", lambda exact: f"{float(exact[0]):.6g}", value).replace(" um", " µm")

    ratio = f" (D/d = {span([g['geometry']['neck_ratio'] for g in statistics.groups if 'neck_ratio' in g['geometry']], 1, '')})" if "neck_ratio" in shape else ""
    friction = scene.get("contact", {}).get("friction", {})
    text = [f"Suspensions of spheres of {span_of_lengths([g['geometry']['diameter'] for g in statistics.groups])}{ratio} were simulated with {common.get('program', 'clogflow')}"
            f"{' (revision ' + common['revision'] + ')' if 'revision' in common else ''}, one-way coupled CFD-DEM: the particles are driven by the flow but do not act back on it."]
    if given("flow", "source") == "openfoam":
        text.append(f"The undisturbed flow (viscosity {given('fluid', 'viscosity')}, mean velocity {given('flow', 'mean_velocity')}) was solved once with OpenFOAM's simpleFoam "
                    f"and read from a regular grid of {given('flow', 'grid_spacing', 'unknown')} spacing.")
    text.append(f"Contacts follow the law \"{given('contact', 'law', 'hertz')}\" with " +
                (f"Young's modulus {given('contact', 'youngs_modulus')}, Poisson's ratio {given('contact', 'poisson_ratio')}, " if given("contact", "youngs_modulus") else "") +
                f"restitution {given('contact', 'restitution', 'unknown')} and coefficients of sliding, rolling and torsional friction of "
                f"{friction.get('sliding', 0)}, {friction.get('rolling', 0)} and {friction.get('torsion', 0)}; drag follows the law \"{given('drag', 'law', 'none')}\""
                f"{', films between particles are lubricated' if given('lubrication', 'enabled') else ''}.")
    step = f"The time step was {float(common['step [s]']):.3g} s" if "step [s]" in common else "The time step depended on the size"
    scale = given("time", "mass_scale", 1)
    text.append(f"{step}{f', with a numerical mass of {scale} times the true one' if scale != 1 else ''}.")
    runs = [r for g in statistics.groups for r in g["runs"]]
    times = span([r["end"] - r["start"] for r in runs], 1, "s")
    text.append(f"{len(runs)} independent runs with random seeds ({'; '.join(sorted({seeds_of(g) for g in statistics.groups}))}) of {times} each were made; "
                f"{AFTER_A_CLOG.get(group['protocol'], group['protocol'])}. A lapse between passages counts as a clog from T_min = {group['t_min'] / group['tau']:.3g} d/v on.")
    text.append("Intervals are 95 % intervals, by bootstrap over seeds unless another kind is named; power laws are fitted and tested after Clauset, Shalizi and Newman, "
                "SIAM Rev. 51 (2009) 661, and survival is estimated after Kaplan and Meier with censored events included.")
    return " ".join(text)


def citation(statistics, common):
    version = statistics.data["program"]
    revision = common.get("revision", "")
    note = f"revision {revision}, " if revision else ""
    return (f"@software{{clogflow,\n  title   = {{clogflow: one-way coupled CFD-DEM of suspensions that clog a constriction}},\n  version = {{{version}}},\n"
            f"  note    = {{{note}scene {', '.join(sorted({g['scene_hash'] for g in statistics.groups})[:4])}}}\n}}")


def commands(statistics, common, made_by):
    """What makes the runs again, and the page from them."""
    groups = statistics.groups
    flow = " --flow flow.h5" if any(g["provenance"].get("flow_hash") for g in groups) else ""
    lines = []
    if flow:
        lines += ["clog case scene.toml case && case/Allrun && clog map case --out flow.h5"]
    for k, group in enumerate(groups):
        name = "scene.toml" if len(groups) == 1 else f"scene_{k}.toml"
        folder = "runs" if len(groups) == 1 else f"runs/{k}"
        lines.append(f"clog run {name}{flow} --seeds {seeds_of(group)} --out {folder}")
    if flow and len(groups) > 1:
        lines[0] = lines[0].replace("scene.toml", "scene_0.toml")
    lines.append("clog stats runs --out runs/stats")
    return "\n".join(lines), made_by or "clog report runs/stats"
