"""Tables and pages that a full disk or a kill leaves as they were, or new; never cut in two."""

import contextlib
import os


@contextlib.contextmanager
def rewritten(path, binary=False):
    """A text file, or a binary one, to write in the place of `path`, which it replaces when all of it is on the disk.
    What cannot be written ends the program with one line; `path` stays as it was then."""
    part = path.with_name(path.name + ".part")
    try:
        with part.open("wb") if binary else part.open("w", encoding="utf-8", newline="") as file:
            yield file
            file.flush()
            os.fsync(file.fileno())
        part.replace(path)
    except OSError as error:
        raise SystemExit(f"{path}: cannot be written ({error.strerror}); it stays as it was") from None
    finally:
        part.unlink(missing_ok=True)
