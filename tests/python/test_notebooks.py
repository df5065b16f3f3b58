"""Every notebook of docs/notebooks runs from its first cell to its last, and is kept without outputs."""

import json
import os
import time
import unittest

import fixtures
import nbclient
import nbformat

NOTEBOOKS = sorted((fixtures.ROOT / "docs/notebooks").glob("*.ipynb"))
LONGEST = 300  # [s] of a cell; they take seconds


class Notebooks(unittest.TestCase):
    def test_they_run(self):
        os.environ |= {"PYTHONPATH": str(fixtures.ROOT / "python"), "PYDEVD_DISABLE_FILE_VALIDATION": "1"}  # the second: no warnings of the debugger
        self.assertGreaterEqual(len(NOTEBOOKS), 2)
        folder = fixtures.scratch()  # of both: the second finds the flow of the first
        for file in NOTEBOOKS:
            with self.subTest(file.name):
                begin = time.monotonic()
                book = nbformat.read(file, as_version=4)
                nbformat.validate(book)
                nbclient.NotebookClient(book, timeout=LONGEST, kernel_name="python3", resources={"metadata": {"path": str(folder)}}).execute()
                code = [cell for cell in book.cells if cell.cell_type == "code"]
                figures = sum("image/png" in output.get("data", {}) for cell in code for output in cell.outputs)
                print(f"{file.name}: {time.monotonic() - begin:.0f} s, {len(code)} cells, {figures} figures")
                self.assertGreaterEqual(figures, 1)
                errors = [output for cell in code for output in cell.outputs if output.get("name") == "stderr"]
                self.assertEqual(errors, [])

    def test_they_hold_no_outputs_and_lead_where_they_say(self):
        for file in NOTEBOOKS:
            for cell in json.loads(file.read_text(encoding="utf-8"))["cells"]:
                if cell["cell_type"] == "code":
                    self.assertEqual((cell["outputs"], cell["execution_count"]), ([], None), file.name)
                for link in "".join(cell["source"]).split("](")[1:] if cell["cell_type"] == "markdown" else []:
                    self.assertTrue((file.parent / link.split(")")[0]).exists(), f"{file.name}: {link}")


if __name__ == "__main__":
    unittest.main()
