"""What each verb is called with, what it makes, and what may stand there before."""

import dataclasses
import shutil
import subprocess
import typing

import crash_inputs


@dataclasses.dataclass
class Verb:
    words: list
    makes: str  # a file or a folder
    before: typing.Optional[typing.Callable] = None  # puts an older result in its place
    places: int = 24  # at which the call is killed
    full: int = 6  # and at which the disk fills
    environment: dict = dataclasses.field(default_factory=dict)


def other_scene(folder):
    text = (folder / "scene.toml").read_text().replace("5 mm/s", "4 mm/s")
    (folder / "other.toml").write_text(text)
    return "other.toml"


def call(clog, folder, *words):
    subprocess.run([clog, *words], cwd=folder, check=True, capture_output=True)


def older_case(folder, clog):
    call(clog, folder, "case", other_scene(folder), "out")
    crash_inputs.pretend_solved(folder / "out")


def older_flow(folder, clog):
    older_case(folder, clog)
    shutil.move(folder / "out", folder / "case_of_other")
    call(clog, folder, "map", "case_of_other", "--out", "out.h5")


def older_text(name):
    def put(folder, _clog):
        file = folder / name
        file.parent.mkdir(exist_ok=True)
        file.write_text("of an older call\n")
    return put


def older_statistics(folder, clog):
    call(clog, folder, "stats", "runs", "--out", "out", "--p-value", "0", "--threshold", "1 ms")


VERBS = {
    "walls": Verb(["walls", "scene.toml", "--out", "out.stl"], "out.stl", older_text("out.stl")),
    "case": Verb(["case", "scene.toml", "out"], "out", older_case),
    "map": Verb(["map", "case", "--out", "out.h5"], "out.h5", older_flow),
    "run": Verb(["run", "scene.toml", "--flow", "flow.h5", "--out", "out"], "out", places=30, full=12),
    "stats": Verb(["stats", "runs", "--out", "out", "--p-value", "0"], "out", older_statistics),
    "export": Verb(["export", "runs/run_0003.h5", "--flow", "flow.h5", "--out", "out"], "out", older_text("out/run_0003.xyz")),
    "trade": Verb(["trade", "--combine", "trade.json", "--out", "out.json"], "out.json", older_text("out.json")),
    "report": Verb(["report", "stats", "--out", "out"], "out", older_text("out/report.html"),
                   environment={"CLOG_PYTHON": "figures/python", "CLOG_FIGURES": "figures"}),
}
