"""docs/reports/trade.md from the committed studies, on standard output. Called by docs/make/make_trade."""

import json
import math
import re
from string import Template

from studies import ROOT, SHORT, Study, interval, short, table

SIZES = ("d47", "d33", "d25")
OBSERVED = ("mean_burst", "early_clogs", "flow_rate_flowing", "packing_near_neck", "coordination")


def named(key):
    return SHORT[key] + (" (points)" if key in ("early_clogs", "share_censored") else "")


def presets(measured):
    rows = []
    for study in measured["studies"]:
        settings = {s["name"]: s for s in study["settings"]}
        for preset in ("standard", "fast"):
            if preset not in study["presets"]:
                rows.append([f"{study['neck_ratio']:.3g}", f"`{preset}`", "none was proved to be so near", "-", "-"])
                continue
            chosen = settings[study["presets"][preset]]
            words = ", ".join(o.split(".", 1)[1].replace("_", " ").replace("=", " ") for o in chosen["overrides"])
            rows.append([f"{study['neck_ratio']:.3g}", f"`{preset}` = {chosen['name']}", words, short(chosen["seconds_per_clog"]), f"**{100 * chosen['within']:.1f} %**"])
    return table(["D/d up to", "preset", "keys", "core-seconds a clog", "every number within, by the law"], rows)


def responses(studies):
    rows = []
    for key in OBSERVED:
        for study in studies:
            r = study.data["responses"][key]
            share = key == "early_clogs"
            cells = []
            for dose in ("softness", "mass", "step"):
                shown = {k: v if share else math.expm1(v) for k, v in zip(("difference", "low", "high"), (r[dose]["slope"], r[dose]["low"], r[dose]["high"]))}
                text = interval(shown, unit=False)
                cells.append(f"**{text}**" if shown["low"] > 0 or shown["high"] < 0 else text)
            rows.append([named(key), f"{study.ratio:.3g}", *cells, f"{r['chi_squared']:.2g} / {r['degrees_of_freedom']} (p = {r['p_value']:.2g})"])
    return table(["", "D/d", "10 MPa", "mass x 30", "step at the limit", "chi squared / degrees of freedom"], rows)


def doses(study):
    rows = [[s["name"], s["runs"], f"{s['clogs']:.0f}", short(s["seconds_per_clog"]), *[interval(s["from_paper"][k], unit=False) for k in OBSERVED],
             f"**{100 * s['within']:.1f}**"] for s in study.doses()]
    return table(["setting", "seeds", "clogs", "s a clog", *map(named, OBSERVED), "within [%]"], rows)


def against(study, kinds, observed=OBSERVED):
    rows = []
    for s in study.settings.values():
        if s["kind"] not in kinds or "against_differences" not in s:
            continue
        cells = []
        for key in observed:
            d = s["against_differences"][key]
            text = interval(d, unit=False)
            cells.append(f"**{text}**" if d["real"] else text)
        rows.append([s["name"], s["against"], f"{s['clogs']:.0f}", short(s["differences"]["mean_burst"]["value"] or math.nan), *cells])
    return table(["setting", "against", "clogs", "value of `<s>`", *(f"{named(key)}, difference" for key in observed)], rows)


def masses(study):
    """What the mass alone does: <s>, clogs and packing of the settings that differ in it, in words."""
    rows = [study.settings[f"10MPa_m{m}_limit70"] for m in (1, 3, 10, 30, 100, 300)]

    def listed(texts):
        return ", ".join(texts[:-1]) + " and " + texts[-1]
    return {"mass_means": listed([f"{r['differences']['mean_burst']['value']:.2f}" for r in rows]),
            "mass_packings": listed([f"{r['differences']['packing_near_neck']['value']:.3f}" for r in rows]),
            "mass_clogs": listed([f"{r['clogs']:.0f}" for r in rows])}


def paper_particles(study):
    """How far the campaign's numerics are from the paper's particles, directly and by the law."""
    base = study.settings["10MPa_m30_limit70"]
    return {f"{kind}_{name}": interval(base[where][key]) for kind, where in (("gpa3", "differences"), ("law", "from_paper"))
            for name, key in (("mean", "mean_burst"), ("packing", "packing_near_neck"))}


def grids(study):
    rows = [[r["name"], f"{100 * r['force']:.2g} %", f"{100 * r['path']:.2g} %"] for r in study.data["short"] if r["name"].startswith("grid")]
    return table(["grid of the flow, 2 um times", "error of the forces", "of the way in tau/10"], rows)


def main():
    studies = [Study(name) for name in SIZES]
    measured = json.loads((ROOT / "trade" / "measured.json").read_text(encoding="utf-8"))
    template = (ROOT / "docs" / "make" / "trade" / "template.md.in").read_text(encoding="utf-8")
    page = Template(template).substitute(
        **masses(studies[0]), **paper_particles(studies[0]), presets=presets(measured), responses=responses(studies), doses="\n\n".join(f"D/d = {s.ratio:.3g}\n\n{doses(s)}" for s in studies),
        direct="\n\n".join(f"D/d = {s.ratio:.3g}\n\n{against(s, ('dose',))}" for s in studies),
        numerics=against(studies[0], ("numerics",)), physics=against(studies[0], ("physics",)), grids=grids(studies[0]),
        spread=responses([Study("s47")]))
    page = re.sub(r"`[^`]*`|<s>", lambda found: r"\<s>" if found[0] == "<s>" else found[0], page)
    print(page.rstrip("\n"))


if __name__ == "__main__":
    main()
