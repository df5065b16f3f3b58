"""CSV tables of results, a row appended as soon as it is known, so that an interrupted call loses one row at most."""

import csv


def read(file):
    """Rows as dictionaries of texts."""
    if not file.exists():
        return []
    with open(file) as text:
        return list(csv.DictReader(text))


def key_of(row, names):
    return tuple(str(row[name]) for name in names)


class Table:
    """Rows named by the columns `keys`. What is in the file is not computed again."""

    def __init__(self, file, keys):
        self.file, self.keys = file, keys
        self.rows = {key_of(row, keys): row for row in read(file)}

    def row(self, compute, **key):
        """The row of that key; compute() gives its other columns where it is not there."""
        name = key_of(key, self.keys)
        if name not in self.rows:
            self.rows[name] = {k: str(v) for k, v in (key | compute()).items()}
            self.write()
        return self.rows[name]

    def write(self):
        self.file.parent.mkdir(parents=True, exist_ok=True)
        columns = list(next(iter(self.rows.values())))
        whole = self.file.with_name(self.file.name + ".part")  # a full disk leaves the rows that were there
        with open(whole, "w", newline="") as out:
            writer = csv.DictWriter(out, columns, lineterminator="\n")
            writer.writeheader()
            writer.writerows(self.rows.values())
        whole.replace(self.file)
