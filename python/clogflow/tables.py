"""How columns are named: as in the tables of `clog stats`.

The unit is in the name, not in `attrs`: pandas drops those in a merge or a concatenation, and a name is seen in every
print. So a table of a run file and one of the program are read alike: `table["time [s]"]`.
"""

import re

import h5py
import numpy as np
import pandas as pd

UNIT = re.compile(r"(.*) \[(.+)\]")


def column_name(name: str, unit: str, column: h5py.Dataset) -> str:
    """`time [s]`; of ids, counts and flags only the name."""
    return f"{name} [{unit}]" if np.issubdtype(column.dtype, np.floating) else name


def units(table: pd.DataFrame) -> dict[str, str]:
    """Unit of each column, "1" where its name has none: {"time [s]": "s", "id": "1"}."""
    return {name: found[2] if (found := UNIT.fullmatch(str(name))) else "1" for name in table.columns}
