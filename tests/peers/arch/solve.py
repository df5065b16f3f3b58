"""Meshes and solves a case; a case that is solved already is left as it is."""

import os
import re
import shutil
import subprocess
import time

STEPS = (["blockMesh"], ["snappyHexMesh", "-overwrite"], ["simpleFoam"],
         ["simpleFoam", "-postProcess", "-latestTime", "-dict", "system/samplesDict"])
PROGRAMS = "blockMesh", "snappyHexMesh", "simpleFoam"


def missing():
    """A line on what is not installed, or nothing."""
    away = [name for name in PROGRAMS if shutil.which(name) is None]
    return f"{away[0]} is not installed (apt-get install openfoam)" if away else ""


def last_words(log):
    text = log.read_text(errors="replace")
    fatal = text.find("--> FOAM FATAL")
    return " ".join(text[fatal:fatal + 400].split()) if fatal >= 0 else text.strip().splitlines()[-1]


def solve(folder):
    """{"cells", "iterations", "seconds"} of the case; raises SystemExit with one line when a step fails."""
    environment = os.environ | {"WM_PROJECT_DIR": os.environ.get("WM_PROJECT_DIR", "/usr/share/openfoam")}
    done = folder / "seconds"
    if not done.exists():
        began = time.perf_counter()
        for number, words in enumerate(STEPS):
            log = folder / f"log.{number}.{words[0]}"
            with open(log, "w") as out:
                status = subprocess.run(words, cwd=folder, stdout=out, stderr=out, env=environment).returncode
            if status:
                raise SystemExit(f"{folder}: {words[0]} stopped with status {status}: {last_words(log)}")
        if "SIMPLE solution converged" not in (folder / "log.2.simpleFoam").read_text():
            raise SystemExit(f"{folder}: simpleFoam did not converge: see log.2.simpleFoam")
        done.write_text(f"{time.perf_counter() - began:.1f}\n")
    mesh, flow = (folder / "log.1.snappyHexMesh").read_text(), (folder / "log.2.simpleFoam").read_text()
    return {"cells": int(re.findall(r"cells:(\d+)", mesh)[-1]),
            "iterations": int(re.findall(r"converged in (\d+)", flow)[-1]),
            "seconds": float(done.read_text())}
