"""What the cells of the page's tables are made of: numbers, intervals, verdicts, notes."""

from dataclasses import dataclass, field

from markupsafe import Markup, escape

RULED_OUT_BELOW = 0.1  # p-value, as Clauset et al.
ROUGH_BELOW = 50       # values in a tail, ibid.


class Cell(Markup):
    """Markup that knows its numbers: tables are sorted by the value and downloaded with its bounds."""

    def __new__(cls, text, value=None, low=None, high=None):
        made = super().__new__(cls, text)
        made.value, made.low, made.high = value, low, high
        return made

    def __add__(self, more):
        return like(self, Markup(str(self)) + more)


@dataclass
class Table:
    name: str    # of the CSV file
    head: list
    rows: list
    about: str = ""                            # below it
    notes: list = field(default_factory=list)  # likewise, marked

    def __bool__(self):
        return bool(self.rows)


def quiet(text):
    return Markup("<span class=quiet>{}</span>").format(text)


def marked(text, mark):
    return like(text, Markup('{} <span class="drifts">{}</span>').format(text, mark))


def like(cell, text):
    """The same numbers in another text."""
    return Cell(text, cell.value, cell.low, cell.high) if isinstance(cell, Cell) else Markup(text)


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
        text = escape(known) + quiet(why or "unknown")
    elif entry["low"] is None:
        text = escape(number(entry["value"])) + " " + quiet(why)
    else:
        text = escape(number(entry["value"])) + " " + quiet(f"[{low}, {high}]" + (f" {why}" if why else ""))
    return Cell(text, entry["value"], entry["low"], entry["high"])


def headline(entry):
    """The same with what stands against it: a law that is ruled out, a run that drifts."""
    text = interval(entry)
    if entry.get("ruled_out"):
        text = marked(text, entry["verdict"])
    elif "verdict" in entry:
        text = like(text, text + " " + quiet(entry["verdict"]))
    return marked(text, "drifts: the halves differ") if entry.get("drifts") else text


def bounded(entry):
    bound = {"lower bound": f"> {number(entry['low'])}", "upper bound": f"< {number(entry['high'])}"}
    known = bound.get(entry["status"])
    if known:
        return Cell(escape(known), None, entry["low"], entry["high"])
    return "–" if entry["value"] is None else interval(entry)


def ruling(verdict):
    return marked("", verdict["verdict"]) if verdict["ruled_out"] else escape(verdict["verdict"])


def size(n):
    return marked(n, "rough") if n < ROUGH_BELOW else n
