"""A Slurm of one node on loopback, in a scratch folder: started by hand, without systemd, and always stopped."""

import getpass
import os
import shutil
import socket
import subprocess
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "srun", "scontrol", "scancel", "sinfo", "squeue")


class Failed(Exception):
    """What the test expected and did not see."""


def missing_programs():
    os.environ["PATH"] += ":/usr/sbin:/sbin"
    return [program for program in PROGRAMS if not shutil.which(program)]


def wait_for(what, condition, seconds):
    """Asks until the condition's value is true, and returns it."""
    end = time.monotonic() + seconds
    while True:
        value = condition()
        if value:
            return value
        if time.monotonic() > end:
            raise Failed(f"waited {seconds} s in vain for {what}")
        time.sleep(0.2)


def said(*command):
    return subprocess.run(command, capture_output=True, text=True, timeout=60).stdout.strip()


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return str(probe.getsockname()[1])


class Cluster:
    def __init__(self, folder):
        self.folder = folder
        self.daemons = []
        values = {"node": socket.gethostname().split(".")[0], "folder": str(folder), "user": getpass.getuser(),
                  "controller_port": free_port(), "node_port": free_port()}
        text = (HERE / "slurm.conf").read_text()
        for key, value in values.items():
            text = text.replace(f"@{key}@", value)
        (folder / "slurm.conf").write_text(text)
        for name in ("state", "spool"):
            (folder / name).mkdir()
        key = folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)
        os.environ["SLURM_CONF"] = str(folder / "slurm.conf")

    def start_daemon(self, *command):
        # Ends with this process, however that ends.
        log = open(self.folder / f"{command[0]}.out", "w")
        self.daemons.append(subprocess.Popen(["setpriv", "--pdeathsig", "TERM", *command], stdout=log, stderr=log))

    def start(self):
        place = {option: f"--{option}={self.folder}/munge.{end}" for option, end in
                 (("key-file", "key"), ("socket", "socket"), ("pid-file", "pid"), ("log-file", "log"), ("seed-file", "seed"))}
        try:
            self.start_daemon("munged", "--foreground", "--force", *place.values())
            wait_for("munged's socket", (self.folder / "munge.socket").exists, 20)
            self.start_daemon("slurmctld", "-D")
            self.start_daemon("slurmd", "-D")
            wait_for("the node", lambda: said("sinfo", "--noheader", "--format=%T").startswith("idle"), 30)
        except Failed:
            self.stop()
            raise

    def __enter__(self):
        return self

    def __exit__(self, *_):
        said("scancel", "--user", getpass.getuser())
        try:
            wait_for("the end of all jobs", lambda: not said("squeue", "--noheader"), 60)
        finally:
            self.stop()

    def stop(self):
        for daemon in reversed(self.daemons):
            daemon.terminate()
            try:
                daemon.wait(10)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()

    def submit(self, *arguments):
        done = subprocess.run(["sbatch", "--parsable", *map(str, arguments)], capture_output=True, text=True, timeout=60)
        if done.returncode:
            raise Failed(f"sbatch refused: {done.stderr.strip()}")
        return done.stdout.strip()

    def tasks(self, job):
        """What Slurm says of a job, or of each task of an array: a dictionary of its keys."""
        lines = said("scontrol", "--oneliner", "show", "job", job).splitlines()
        return [dict(word.split("=", 1) for word in line.split() if "=" in word) for line in lines]
