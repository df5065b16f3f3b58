"""What goes wrong, in one line each: what, where, what to do."""


class ClogflowError(Exception):
    """Every refusal of this package. Its text is one line for a person to read."""


class FileError(ClogflowError):
    """A file that is missing, cut short, damaged, or of another kind."""


class ProgramError(ClogflowError):
    """The program refused or failed, took too long, or is not there.

    The text is the program's own line; `status` its exit status (None: it never ended by itself), `output` all it said.
    """

    def __init__(self, text: str, status: int | None = None, output: str = "") -> None:
        super().__init__(text)
        self.status = status
        self.output = output
