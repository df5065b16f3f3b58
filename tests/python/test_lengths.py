"""Lengths on figures and pages: micrometres of a suspension, millimetres of a silo; one place decides."""

import pathlib
import sys
import types
import unittest

import matplotlib

matplotlib.use("Agg")
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "postprocess/figures"))

import channel  # noqa: E402  (found through the line above)
import fig_trend  # noqa: E402
import lengths  # noqa: E402
import matplotlib.pyplot as plt  # noqa: E402
import page_tables  # noqa: E402
import page_text  # noqa: E402


def geometry_of(neck, diameter):
    """A straight channel three necks wide."""
    side = [[-5 * neck, 1.5 * neck], [0, neck / 2], [neck, neck / 2]]
    return {"present": True, "neck_width": neck, "neck_height": neck, "diameter": diameter, "neck_ratio": neck / diameter, "mean_velocity": 0,
            "upper": side, "lower": [[x, -y] for x, y in side]}


SUSPENSION, SILO = geometry_of(100e-6, 33e-6), geometry_of(20e-3, 8e-3)


class Lengths(unittest.TestCase):
    def test_a_millimetre_divides_the_units(self):
        self.assertEqual(lengths.unit_of(999e-6).name, "µm")
        self.assertEqual(lengths.unit_of(1e-3).name, "mm")
        self.assertEqual(lengths.unit_of(0.9e-3, 1.2e-3).name, "mm")
        for length in (33e-6, 8e-3):
            unit = lengths.unit_of(length)
            self.assertAlmostEqual(length * unit.per_metre, {"µm": 33, "mm": 8}[unit.name])

    def test_without_a_channel_the_particles_decide(self):
        self.assertEqual(lengths.unit_of_scene({"present": False, "diameter": 8e-3}).name, "mm")
        self.assertEqual(lengths.unit_of_scene({"present": False, "diameter": 33e-6}).name, "µm")

    def test_the_sentence(self):
        for shape, said in ((SUSPENSION, "Spheres of 33 µm (D/d = 3.03) through a neck of 100 µm × 100 µm:"),
                            (SILO, "Spheres of 8 mm (D/d = 2.5) through a neck of 20 mm × 20 mm:")):
            group = {"geometry": shape, "runs": [{"start": 0, "end": 1}], "protocol": "poke"}
            statistics = types.SimpleNamespace(groups=[group], data={})
            self.assertTrue(page_text.sentence(statistics).startswith(said), page_text.sentence(statistics))

    def test_axes_of_the_channel(self):
        for shape, right in ((SUSPENSION, 100), (SILO, 20)):
            figure, axes = plt.subplots()
            channel.draw(axes, shape)
            self.assertAlmostEqual(axes.get_xlim()[1], right)
            plt.close(figure)

    def test_a_swept_length(self):
        self.assertEqual(fig_trend.shown_in("m", [33e-6, 47e-6]), ("µm", 1e6))
        self.assertEqual(fig_trend.shown_in("m", [5.714e-3, 8e-3]), ("mm", 1e3))
        self.assertEqual(fig_trend.shown_in("Pa", [1.0]), ("Pa", 1.0))

    def test_the_table_of_sizes(self):
        for diameter, head, cell in ((33e-6, "mean diameter of passages [µm] (of the feed)", "of 33"),
                                     (8e-3, "mean diameter of passages [mm] (of the feed)", "of 8")):
            entry = {"value": diameter, "low": diameter, "high": diameter, "status": "measured", "note": ""}
            rows = page_tables.sizes([{"sizes": {"passage_diameter": entry, "feed_diameter": diameter, "species": []}}])
            self.assertEqual(rows[0][0], head)
            self.assertIn(cell, str(rows[0][1]))
