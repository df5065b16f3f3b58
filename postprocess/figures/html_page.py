"""One self-contained HTML page: what was simulated, a film, figures, tables, and how it was made."""

from pathlib import Path

import jinja2
import page_figures
import page_tables
import page_text
import player

HERE = Path(__file__).parent


def film(statistics, figures):
    """What the page needs of the player; the still of the same run in its place where it cannot play."""
    parts = player.section(statistics)
    still = next((figure for figure in figures if figure["name"].split("_")[0] == "snapshots"), None)
    return parts | ({"still": still} if "frame" in parts else {})


def notes(groups):
    """Each once, with whom it concerns unless it is all."""
    concerned = {}
    for group in groups:
        for line in group["notes"]:
            concerned.setdefault(line, []).append(group["label"])
    return [line if len(labels) == len(groups) > 1 else f"{', '.join(labels)}: {line}" for line, labels in concerned.items()]


def context(statistics, paths, flow, command):
    groups = statistics.groups
    common, runs = page_tables.runs(groups)
    of_all, of_points = page_figures.entries([path for path in paths if path.suffix == ".png"], statistics)
    played = film(statistics, of_points + of_all)
    shown = played.get("still")
    flow_rows, flow_words = page_text.flow_error(statistics, flow)
    steps, made_by = page_text.commands(statistics, common, command)
    return {"title": groups[0]["label"] if len(groups) == 1 else f"Sweep of {len(groups)} scenes", "sentence": page_text.sentence(statistics),
            "program": f"clogflow {statistics.data['program']}", "groups": groups, "notes": notes(groups),
            "cards": page_text.three_numbers(statistics), "film": played,
            "figures": [f for f in of_all if f is not shown], "of_points": [f for f in of_points if f is not shown],
            "numbers": page_tables.summary(groups), "necks": page_tables.necks(groups), "sweep": page_tables.sweep(statistics),
            "halves": page_tables.halves(groups), "fits": page_tables.fits(groups), "runs": runs, "common": common,
            "methods": page_text.methods(statistics, common), "citation": page_text.citation(statistics, common),
            "steps": steps, "made_by": made_by, "flow_rows": flow_rows, "flow_words": flow_words}


def write(statistics, paths, folder, flow="", command=""):
    templates = jinja2.Environment(loader=jinja2.FileSystemLoader(HERE), autoescape=True, undefined=jinja2.StrictUndefined, trim_blocks=True,
                                   lstrip_blocks=True)
    page = templates.get_template("report.html").render(
        context(statistics, paths, flow, command), style=(HERE / "page.css").read_text(encoding="utf-8"), script=(HERE / "page.js").read_text(encoding="utf-8"))
    target = Path(folder) / "report.html"
    target.write_text(page, encoding="utf-8")
    return target
