"""Reads what `clog stats` wrote: stats.json and the CSV tables."""

import csv
import json
import math
from pathlib import Path


class Statistics:
    """The groups of stats.json; `rows` gives the rows of a table that belong to one of them."""

    def __init__(self, folder):
        self.folder = Path(folder)
        with open(self.folder / "stats.json", encoding="utf-8") as file:
            data = json.load(file)
        if data.get("format") != "clogflow statistics" or data.get("version") != 1:
            raise SystemExit(f"{self.folder / 'stats.json'}: not statistics of version 1 (run clog stats again)")
        self.data = data
        self.groups = data["groups"]
        self._tables = {}

    def rows(self, table, group):
        """Rows of `table`.csv of group number `group`, as dictionaries with numbers where they are numbers."""
        if table not in self._tables:
            with open(self.folder / f"{table}.csv", encoding="utf-8", newline="") as file:
                self._tables[table] = [{k: _number(v) for k, v in row.items()} for row in csv.DictReader(file)]
        return [row for row in self._tables[table] if row["group"] == group]


def _number(text):
    try:
        return float(text)
    except ValueError:
        return text


def value(group, key):
    """(value, low, high) of a quantity, NaN where undefined."""
    entry = group["quantities"][key]
    return tuple(math.nan if entry[k] is None else entry[k] for k in ("value", "low", "high"))


def suffix(statistics, index):
    """Appended to the names of figures that exist once a group."""
    return "" if len(statistics.groups) == 1 else f"_{index}"
