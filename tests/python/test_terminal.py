"""--quiet, --log, --json, colours and the disk that a plan foretells: one mechanism for all verbs."""

import json
import os
import pathlib
import pty
import re
import subprocess
import sys
import unittest

import fixtures

RED, YELLOW = "\x1b[1;31m", "\x1b[33m"
STAMP = re.compile(r"\d{4}-\d\d-\d\d \d\d:\d\d:\d\d\.\d{3} [+-]\d{4}  ")
SMALL = {"time.end": "20 ms", "inlet.start": "filled", "unclog.protocol": "none", "particles.diameter": "45 um"}


def sets(values):
    return [word for key, value in values.items() for word in ("--set", f"{key}={value}")]


def clog(*words, **options):
    return subprocess.run([fixtures.PROGRAM, *words], cwd=fixtures.folder(), capture_output=True, text=True, check=False, **options)


def on_a_terminal(*words, **variables):
    """What a terminal shows of both streams, and the status."""
    ours, theirs = pty.openpty()
    environment = {key: value for key, value in os.environ.items() if key not in ("NO_COLOR", "TERM")} | {"TERM": "xterm"} | variables
    process = subprocess.Popen([fixtures.PROGRAM, *words], cwd=fixtures.folder(), stdout=theirs, stderr=theirs, env=environment)
    os.close(theirs)
    shown = b""
    while True:
        try:
            piece = os.read(ours, 4096)
        except OSError:  # the other side has closed it
            break
        if not piece:
            break
        shown += piece
    os.close(ours)
    return shown.decode().replace("\r\n", "\n"), process.wait()


def verbs():
    """{name: its help} of every verb."""
    listed = clog("--help").stdout.split("Subcommands:")[1]
    names = re.findall(r"^  ([\w-]+)", listed, re.M)
    return {name: clog(name, "--help").stdout for name in names}


class Words(unittest.TestCase):
    def test_the_page_has_words_for_every_protocol(self):
        sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "postprocess/figures"))
        from page_text import AFTER_A_CLOG  # noqa: PLC0415

        [key] = json.loads(clog("keys", "unclog.protocol", "--json").stdout)["keys"]
        self.assertEqual(list(AFTER_A_CLOG), key["allowed"])


class EveryVerb(unittest.TestCase):
    def test_has_the_options(self):
        helps = verbs()
        self.assertLess({"plan", "case", "map", "run", "stats", "report", "film", "export", "info"}, set(helps))
        for name, text in helps.items():
            self.assertIn("--quiet", text, name)
            self.assertIn("--log", text, name)
        for name in ("plan", "info", "stats"):
            self.assertIn("--json", helps[name])

    def test_speaks_through_one_file(self):
        """What went past cli/output.cpp would be missing in the log, and show with --quiet and --json."""
        for file in (fixtures.ROOT / "cli").glob("*.cpp"):
            if file.name != "output.cpp":
                self.assertIsNone(re.search(r"fmt::print|\bputs\(|printf\(|std::c(out|err)|\bisatty\(", file.read_text()), file.name)


class Quiet(unittest.TestCase):
    def test_leaves_results_and_errors(self):
        full, quiet = clog("plan", "scene.toml").stdout, clog("plan", "scene.toml", "--quiet").stdout
        for line in ("decided by", "explicit drag"):
            self.assertIn(line, full)
            self.assertNotIn(line, quiet)
        for line in ("time step", "one seed: about", "disk: "):
            self.assertIn(line, quiet)
        refused = clog("plan", "nowhere.toml", "--quiet")
        self.assertEqual((refused.returncode, refused.stdout), (1, ""))
        self.assertTrue(refused.stderr.startswith("clog: nowhere.toml"), refused.stderr)

    def test_run_says_what_the_seeds_did(self):
        words = ["run", "scene.toml", "--flow", "flow.h5", *sets(SMALL), "--seeds", "5"]
        loud = clog(*words, "--out", "loud")
        quiet = clog(*words, "--out", "quiet", "--quiet")
        self.assertIn("clog: seed 5: dt = ", loud.stderr)
        self.assertEqual(quiet.stderr, "")
        self.assertRegex(quiet.stdout, r"^seed 5: 0\.02 s simulated in [^\n]*\n$")


class Log(unittest.TestCase):
    def test_has_every_line_with_its_time(self):
        log = fixtures.folder() / "all.log"
        said = clog("plan", "scene.toml", "--log", log.name)
        clog("info", "nowhere.h5", "--log", log.name, "--quiet")
        lines = log.read_text().splitlines()
        for line in lines:
            self.assertRegex(line, STAMP)
        bare = [STAMP.sub("", line, count=1) for line in lines]
        self.assertRegex(bare[0], r"^clogflow [\d.]+: clog plan scene.toml --log all.log$")
        count = len(said.stdout.splitlines())
        self.assertEqual(bare[1:count + 1], said.stdout.splitlines())
        self.assertIn("info nowhere.h5", bare[count + 1])
        self.assertTrue(bare[count + 2].startswith("clog: nowhere.h5"), bare)

    def test_has_also_what_quiet_and_json_leave_out(self):
        log = fixtures.folder() / "quiet.log"
        clog("plan", "scene.toml", "--quiet", "--log", log.name)
        self.assertIn("explicit drag", log.read_text())
        json.loads(clog("plan", "scene.toml", "--json", "--log", log.name).stdout)

    def test_never_spoils_a_file_of_another_kind(self):
        flow = fixtures.folder() / "flow.h5"
        before = flow.read_bytes()
        refused = clog("info", "flow.h5", "--log", "flow.h5")
        self.assertEqual(refused.returncode, 1)
        self.assertEqual(refused.stderr, "clog: --log flow.h5: is there and no log of this program: give another name\n")
        self.assertEqual(flow.read_bytes(), before)
        self.assertIn("--log nowhere/x.log: cannot be written (No such file or directory)",
                      clog("info", "flow.h5", "--log", "nowhere/x.log").stderr)

    def test_a_full_disk_is_said(self):
        full = clog("info", "flow.h5", "--log", "/dev/full")
        self.assertEqual(full.returncode, 1)
        self.assertIn("--log /dev/full: cannot be written (disk full?)", full.stderr)
        self.assertIn("a flow file", full.stdout)

    def test_of_several_ranks_has_whole_lines(self):
        log = fixtures.folder() / "ranks.log"
        words = ["run", "scene.toml", "--flow", "flow.h5", *sets(SMALL), "--seeds", "11-14", "--out", "ranks", "--log", log.name]
        allowed = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"} if os.geteuid() == 0 else {}
        subprocess.run(["mpirun", "-np", "3", "--oversubscribe", "--bind-to", "none", fixtures.PROGRAM, *words], cwd=fixtures.folder(),
                       env={**os.environ, **allowed}, check=True, capture_output=True)
        bare = [STAMP.sub("", line, count=1) for line in log.read_text().splitlines()]
        self.assertEqual(sum("clog run scene.toml" in line for line in bare), 1)  # of rank 0 alone
        for seed in range(11, 15):
            self.assertEqual(sum(line.startswith(f"seed {seed}: ") for line in bare), 1, bare)


class Json(unittest.TestCase):
    def test_plan(self):
        said = clog("plan", "scene.toml", "--json")
        plan = json.loads(said.stdout)
        self.assertEqual((said.stderr, plan["format"], plan["version"]), ("", "clogflow plan", 1))
        text = clog("plan", "scene.toml").stdout
        self.assertAlmostEqual(plan["time_step_s"], float(re.search(r"time step (\S+) s", text)[1]), delta=1e-3 * plan["time_step_s"])
        self.assertEqual(round(plan["seed"]["particles"]), int(re.search(r"about (\d+) particles", text)[1]))
        self.assertEqual(plan["disk"]["ensemble_bytes"], plan["disk"]["run_bytes"] * plan["disk"]["runs"])
        self.assertLessEqual({"contact_time_s", "rayleigh_time_s", "explicit_drag_s", "lubrication_s", "contacts_in_a_pack_s",
                              "way_in_the_neck_s"}, set(plan["limits"]))
        self.assertEqual([term["term"] in text for term in plan["terms"]], [True] * len(plan["terms"]))
        self.assertGreater(len(plan["terms"]), 5)
        self.assertTrue(re.fullmatch(r"[\d.]+ um", plan["scene"]["particles.diameter"]))
        with_flow = json.loads(clog("plan", "scene.toml", "--json", "--flow", "flow.h5").stdout)["flow"]
        self.assertGreater(with_flow["measured_reach_m"], 0)

    def test_info_of_each_kind(self):
        import clogflow
        run, flow = clogflow.Run(fixtures.folder() / "runs/run_0003.h5"), clogflow.Flow(fixtures.folder() / "flow.h5")
        of_run = json.loads(clog("info", "runs/run_0003.h5", "--json").stdout)
        self.assertEqual((of_run["seed"], of_run["passages"], of_run["snapshots"]), (3, len(run.passages), len(run.snapshots)))
        self.assertEqual(of_run["simulated_s"], run.end_time)
        self.assertEqual(of_run["provenance"]["wall_time_s"], run.provenance["wall_time_s"])
        of_flow = json.loads(clog("info", "flow.h5", "--json").stdout)
        self.assertEqual(of_flow["points"], list(flow.points))
        self.assertAlmostEqual(of_flow["fluid_share"], 1 - flow.solid.mean(), places=12)
        of_scene = json.loads(clog("info", "scene.toml", "--json").stdout)
        self.assertEqual(of_scene["flow_hash"], of_flow["hash"])
        self.assertEqual(of_scene["scene"]["geometry.neck_width"], of_run["scene"]["geometry.neck_width"])
        self.assertEqual(clog("pack", "ranks_to_pack", "--out", "x.h5").returncode, 1)  # nothing there: no pack to tell of
        self.assertEqual(clog("info", "scene.toml", "--json", "--effective").returncode, 1)

    def test_stats_is_stats_json(self):
        said = clog("stats", "runs", "--out", "json_stats", "--p-value", "0", "--json")
        written = json.loads((fixtures.folder() / "json_stats/stats.json").read_text())
        self.assertEqual(json.loads(said.stdout), written)
        self.assertIn("units", written)


class Colours(unittest.TestCase):
    def test_on_a_terminal_only_and_never_against_the_will(self):
        words = ("plan", "scene.toml", "--set", "time.mass_scale=1e6")
        shown, status = on_a_terminal(*words)
        self.assertEqual(status, 0, shown)
        self.assertIn(f"{YELLOW}warning:", shown)
        self.assertIn(f"{RED}clog:", on_a_terminal("info", "nowhere.h5")[0])
        self.assertNotIn("\x1b", clog(*words).stdout)
        for variables in ({"NO_COLOR": "1"}, {"TERM": "dumb"}):
            self.assertNotIn("\x1b", on_a_terminal(*words, **variables)[0])
        self.assertIn(YELLOW, on_a_terminal(*words, NO_COLOR="")[0])  # set, but empty: no-color.org

    def test_a_log_has_none(self):
        on_a_terminal("info", "nowhere.h5", "--log", "colour.log")
        self.assertNotIn("\x1b", (fixtures.folder() / "colour.log").read_text())


class Disk(unittest.TestCase):
    FACTOR = 2  # that docs/terminal.md promises

    def test_is_what_runs_take(self):
        cases = {"snapshots": SMALL | {"output.snapshot_interval": "200 us", "output.series_interval": "20 us"},
                 "plain": SMALL | {"output.series_interval": "1 ms"},
                 "bursts": SMALL | {"inlet.start": "flowing", "unclog.protocol": "restart", "output.burst_snapshots": "100 us"}}
        for name, values in cases.items():
            planned = json.loads(clog("plan", "scene.toml", "--json", *sets(values)).stdout)["disk"]
            done = clog("run", "scene.toml", "--flow", "flow.h5", "--out", f"disk_{name}", "--seeds", "3", *sets(values))
            self.assertEqual(done.returncode, 0, done.stderr)
            real = sum(file.stat().st_size for file in pathlib.Path(fixtures.folder() / f"disk_{name}").glob("run_0003.*"))
            ratio = planned["run_bytes"] / real
            self.assertGreater(ratio, 0.9 if planned["at_most"] else 1 / self.FACTOR, (name, planned, real))
            if name != "bursts":  # of which there were fewer than there could be
                self.assertLess(ratio, self.FACTOR, (name, planned, real))
