"""The program's statistics as the package hands them on, against scipy and against their definitions."""

import json
import unittest

import fixtures
import numpy as np
import scipy.optimize
import scipy.special
import scipy.stats

import clogflow


def kaplan_meier(times, censored):
    """{t: S(t)}: the product over the times of events of 1 - events / at risk, by its definition."""
    survival, result = 1.0, {}
    for t in np.unique(times[~censored]):
        survival *= 1 - np.sum((times == t) & ~censored) / np.sum(times >= t)
        result[t] = survival
    return result


class OfAnEnsemble(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.ensemble = clogflow.Ensemble(fixtures.known(), program=fixtures.PROGRAM)
        cls.statistics = cls.ensemble.statistics

    def test_tables_are_those_of_the_program(self):
        arrests, lapses = self.ensemble.arrests, self.ensemble.lapses
        threshold = self.statistics.groups[0]["t_min"]
        self.assertAlmostEqual(threshold, fixtures.TAU / 2)
        self.assertEqual(len(arrests), int(np.sum(lapses["T [s]"] >= threshold)))
        self.assertGreater(int(np.sum(~arrests["censored"])), 200)
        self.assertGreater(int(np.sum(arrests["censored"])), 10)
        self.assertEqual(len(self.ensemble.passages), sum(entry["passages"] for entry in self.statistics.groups[0]["runs"]))

    def test_lapses_are_the_differences_of_the_passages(self):
        lapses = self.ensemble.lapses
        for run in self.ensemble.runs[:5]:
            mine = lapses[(lapses["seed"] == run.seed) & (lapses["ended_by"] == "passage")]["T [s]"]
            # Between files and tables a time is written with all its digits, a difference loses some.
            np.testing.assert_allclose(np.sort(mine), np.sort(np.diff(run.passages["time [s]"])), atol=1e-15)

    def test_kaplan_meier_by_its_definition(self):
        arrests, table = self.ensemble.arrests, self.statistics.arrest_survival
        expected = kaplan_meier(arrests["T [s]"].to_numpy(), arrests["censored"].to_numpy())
        steps = table[table["ended"] > 0]
        np.testing.assert_allclose(steps["T [s]"], list(expected))
        np.testing.assert_allclose(steps["S [1]"], list(expected.values()), rtol=1e-12)

    def test_exponent_of_censored_arrests_is_where_scipy_finds_the_largest_likelihood(self):
        arrests, t_min = self.ensemble.arrests, self.statistics.groups[0]["t_min"]
        times, censored = arrests["T [s]"].to_numpy(), arrests["censored"].to_numpy()

        def minus_log_likelihood(alpha):
            law = scipy.stats.pareto(alpha - 1, scale=t_min)
            return -np.sum(law.logpdf(times[~censored])) - np.sum(law.logsf(times[censored]))

        best = scipy.optimize.minimize_scalar(minus_log_likelihood, bounds=(1.01, 6), method="bounded", options={"xatol": 1e-9})
        found = self.statistics.quantity("alpha_fixed")
        self.assertAlmostEqual(found.value, best.x, 5)
        self.assertLess(abs(found.value - 2.2), 0.3)  # the law the arrests were drawn from
        self.assertLess(found.low, 2.2)
        self.assertGreater(found.high, 2.2)

    def test_mean_burst_is_the_mean_of_the_counted_bursts(self):
        bursts = self.ensemble.bursts
        counted = bursts[~bursts["kind"].isin(["cut off"])]
        self.assertAlmostEqual(self.statistics.quantity("mean_burst").value, counted["s [1]"].mean(), 12)

    def test_a_run_alone_and_files_of_any_place(self):
        run = self.ensemble.runs[0]
        mine = self.ensemble.bursts[self.ensemble.bursts["seed"] == run.seed]
        self.assertEqual(list(run.bursts["s [1]"]), list(mine["s [1]"]))
        two = clogflow.statistics([run.path, self.ensemble.runs[1].path], p_value=0)
        self.assertEqual([entry["seed"] for entry in two.groups[0]["runs"]], [1, 2])

    def test_out_keeps_what_was_written(self):
        out = fixtures.folder() / "kept"
        written = clogflow.statistics(fixtures.known(), out=out, threshold="9 ms", p_value=0)
        self.assertEqual(written.groups[0]["t_min"], 9e-3)
        self.assertEqual(json.loads((out / "stats.json").read_text())["groups"][0]["t_min"], 9e-3)
        self.assertEqual(len(clogflow.Statistics(out).arrests), len(written.arrests))

    def test_a_quantity_that_is_none(self):
        with self.assertRaisesRegex(KeyError, "no quantity 'speed' of group 0; there are alpha_fixed, first_burst"):
            self.statistics.quantity("speed")

    def test_the_programs_refusal_is_the_text(self):
        with self.assertRaisesRegex(clogflow.ProgramError, "--threshold 9 mm .must be a positive time") as caught:
            clogflow.statistics(fixtures.known(), threshold="9 mm")
        self.assertEqual(caught.exception.status, 1)


class OfNumbers(unittest.TestCase):
    def test_continuous_fit_against_scipy(self):
        values = scipy.stats.pareto(1.5, scale=2).rvs(500, random_state=3)
        found = clogflow.fit(values, xmin=2)
        shape, _, _ = scipy.stats.pareto.fit(values, floc=0, fscale=2)
        self.assertAlmostEqual(found["alpha"], shape + 1, 6)
        self.assertAlmostEqual(found["sigma"], (found["alpha"] - 1) / np.sqrt(500), 6)
        steps = np.arange(500) / 500
        distance = np.max(np.abs(scipy.stats.pareto(found["alpha"] - 1, scale=2).cdf(np.sort(values)) - steps))
        self.assertAlmostEqual(found["ks"], distance, 9)
        _, scale = scipy.stats.expon.fit(values, floc=2)
        self.assertAlmostEqual(found["exponential"]["rate"], 1 / scale, 9)

    def test_scanned_lower_end_is_the_one_of_the_smallest_distance(self):
        random = np.random.default_rng(5)
        values = np.concatenate([random.uniform(0.2, 1, 100), scipy.stats.pareto(1.8).rvs(300, random_state=5)])
        found = clogflow.fit(values)
        distances = {}
        for xmin in np.unique(values)[:-10]:
            tail = np.sort(values[values >= xmin])
            shape, _, _ = scipy.stats.pareto.fit(tail, floc=0, fscale=xmin)
            distances[xmin] = np.max(np.abs(scipy.stats.pareto(shape, scale=xmin).cdf(tail) - np.arange(len(tail)) / len(tail)))
        self.assertAlmostEqual(found["xmin"], min(distances, key=distances.get), 12)
        self.assertAlmostEqual(found["ks"], min(distances.values()), 9)

    def test_discrete_fit_against_the_likelihood_of_scipys_zeta(self):
        values = scipy.stats.zipf(2.5).rvs(800, random_state=4)

        def minus_log_likelihood(alpha):
            return len(values) * np.log(scipy.special.zeta(alpha, 1)) + alpha * np.sum(np.log(values))

        best = scipy.optimize.minimize_scalar(minus_log_likelihood, bounds=(1.1, 6), method="bounded", options={"xatol": 1e-10})
        found = clogflow.fit(values, xmin=1)
        self.assertTrue(found["discrete"])
        self.assertAlmostEqual(found["alpha"], best.x, 5)


if __name__ == "__main__":
    unittest.main()
