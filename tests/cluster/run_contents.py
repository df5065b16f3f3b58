"""Run files, to be compared bit by bit."""

import h5py


def contents(file):
    """All datasets and attributes of a run file but those that hold the wall time: its provenance and its last state."""
    found = {}

    def note(name, item):
        if name.split("/")[0] in ("provenance", "end_state"):
            return
        found[name] = {key: str(value) for key, value in item.attrs.items()}
        if isinstance(item, h5py.Dataset):
            found[name]["values"] = (str(item.dtype), item.shape, item[()].tobytes())

    with h5py.File(file) as run:
        run.visititems(note)
    return found
