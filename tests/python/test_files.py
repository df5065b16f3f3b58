"""Run, Ensemble, Flow, Scene: the numbers of the files, and one line for every file that is none."""

import shutil
import unittest

import fixtures
import h5py
import numpy as np
import pandas as pd

import clogflow


class Tables(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.path = fixtures.folder() / "runs/run_0003.h5"
        cls.run_file = clogflow.Run(cls.path)

    def test_every_column_of_every_table_is_there_with_its_unit(self):
        run = self.run_file
        with h5py.File(self.path) as file:
            for table in ("passages", "releases", "series"):
                read = getattr(run, table)
                units = clogflow.units(read)
                for name, column in file[table].items():
                    if name == "porosity":
                        continue
                    unit = column.attrs["unit"].decode()
                    key = f"{name} [{unit}]" if column.dtype.kind == "f" else name
                    self.assertTrue(np.array_equal(read[key], column[:]), f"{table} {key}")
                    self.assertEqual(units[key], unit)
            for strip in range(file["series/porosity"].shape[1]):
                self.assertTrue(np.array_equal(run.series[f"porosity_{strip + 1} [1]"], file["series/porosity"][:, strip]))
            self.assertEqual(run.end_time, file["end_time"][0])
        self.assertEqual(run.seed, 3)
        self.assertEqual(run.passages["friction_off"].dtype, bool)
        self.assertGreater(len(run.series), 3)

    def test_snapshots_are_the_rows_between_first_and_next(self):
        run = self.run_file
        with h5py.File(self.path) as file:
            first, total = file["snapshots/first"][:], len(file["snapshots/id"])
            for k, snapshot in enumerate(run.snapshots):
                end = first[k + 1] if k + 1 < len(first) else total
                self.assertEqual(len(snapshot), end - first[k])
                for name in ("id", "radius", "position", "velocity", "spin", "force", "torque"):
                    self.assertTrue(np.array_equal(getattr(snapshot, name), file[f"snapshots/{name}"][first[k]:end]), name)
                self.assertEqual(snapshot.time, file["snapshots/time"][k])
        self.assertEqual(len(run.snapshots), len(first))
        self.assertGreater(len(run.snapshots), 1)
        self.assertTrue(np.array_equal(run.snapshots[-1].position, snapshot.position))
        self.assertEqual([s.time for s in run.snapshots[:2]], list(run.snapshots.times[:2]))
        middle = 0.4 * run.snapshots.times[0] + 0.6 * run.snapshots.times[1]
        self.assertEqual(run.snapshots.at(middle).time, run.snapshots.times[1])
        with self.assertRaises(IndexError):
            run.snapshots[len(run.snapshots)]

    def test_contacts_are_there_where_they_were_recorded_and_those_overlap(self):
        self.assertIsNone(self.run_file.snapshots[0].contacts)
        run = clogflow.Run(fixtures.touching())
        with h5py.File(run.path) as file:
            first, total = file["contacts/first"][:], len(file["contacts/a"])
            for k, snapshot in enumerate(run.snapshots):
                end = first[k + 1] if k + 1 < len(first) else total
                self.assertEqual(len(snapshot.contacts), end - first[k])
                for name in ("a", "b", "normal", "force"):
                    self.assertTrue(np.array_equal(getattr(snapshot.contacts, name), file[f"contacts/{name}"][first[k]:end]), name)
        last = run.snapshots[-1]
        contacts = last.contacts
        self.assertGreater(len(contacts), 10)
        np.testing.assert_allclose(np.linalg.norm(contacts.normal, axis=1), 1, rtol=1e-6)
        self.assertTrue(np.all(contacts.normal_force > 0))
        # The normal of a pair runs from the centre of b to that of a, and these overlap.
        pairs = contacts.b >= 0
        a, b = (np.searchsorted(last.id, ids[pairs]) for ids in (contacts.a, contacts.b))
        apart = last.position[a] - last.position[b]
        distance = np.linalg.norm(apart, axis=1)
        self.assertTrue(np.all(distance < last.radius[a] + last.radius[b]))
        np.testing.assert_allclose(apart / distance[:, None], contacts.normal[pairs], atol=1e-6)

    def test_the_scene_is_in_si_units(self):
        scene = self.run_file.scene
        self.assertEqual(scene["particles.diameter"], 50e-6)
        self.assertEqual(scene.unit("particles.diameter"), "m")
        self.assertEqual((scene["fluid.viscosity"], scene.unit("fluid.viscosity")), (1.8e-3, "Pa s"))
        self.assertEqual((scene["contact.friction.sliding"], scene.unit("contact.friction.sliding")), (0.5, "1"))
        self.assertEqual(scene["unclog.protocol"], "release")
        self.assertIn("particles.diameter", scene)
        self.assertNotIn("particles.colour", scene)
        with self.assertRaisesRegex(KeyError, "the scene has no particles.colour"):
            scene["particles.colour"]

    def test_provenance_says_who_wrote_it(self):
        self.assertRegex(self.run_file.provenance["program"], "^clogflow ")
        self.assertIsNone(self.run_file.clogged_at)

    def test_an_ensemble_has_the_rows_of_its_runs(self):
        ensemble = clogflow.Ensemble(fixtures.folder() / "runs")
        self.assertEqual([run.seed for run in ensemble], [3, 4])
        for table in ("passages", "releases", "series"):
            together = getattr(ensemble, table)
            for run in ensemble:
                mine = together[together["seed"] == run.seed].drop(columns=["point", "seed"]).reset_index(drop=True)
                pd.testing.assert_frame_equal(mine, getattr(run, table), check_dtype=False)

    def test_a_flow_is_the_grid_of_the_file(self):
        flow = clogflow.Flow(fixtures.folder() / "flow.h5")
        with h5py.File(flow.path) as file:
            self.assertTrue(np.array_equal(flow.velocity, file["VTKHDF/PointData/U"][:]))
            self.assertTrue(np.array_equal(flow.solid, file["VTKHDF/PointData/solid"][:] == 1))
            self.assertTrue(np.array_equal(flow.walls, file["walls/triangles"][:]))
        self.assertEqual(flow.velocity.shape, (len(flow.z), len(flow.y), len(flow.x), 3))
        self.assertAlmostEqual(flow.x[1] - flow.x[0], 10e-6)
        # A plug: the mean velocity of the scene in the wide part, twice as much in the neck, none in the walls.
        j, k, mean = np.argmin(np.abs(flow.y)), len(flow.z) // 2, flow.scene["flow.mean_velocity"]
        for x, times in ((-150e-6, 1), (50e-6, 2)):
            self.assertLess(abs(flow.velocity[k, j, np.argmin(np.abs(flow.x - x)), 0] / (times * mean) - 1), 0.1)
        self.assertGreater(np.count_nonzero(flow.solid), 0)
        self.assertEqual(np.abs(flow.velocity[flow.solid]).max(), 0)


class Refusals(unittest.TestCase):
    def setUp(self):
        self.folder = fixtures.folder()
        self.good = self.folder / "runs/run_0003.h5"

    def refuses(self, what, pattern):
        with self.assertRaisesRegex(clogflow.FileError, pattern) as caught:
            what()
        self.assertNotIn("\n", str(caught.exception))

    def changed(self, name, change):
        file = self.folder / name
        shutil.copy(self.good, file)
        with h5py.File(file, "r+") as opened:
            change(opened)
        return file

    def test_what_is_no_file(self):
        self.refuses(lambda: clogflow.Run(self.folder / "none.h5"), r"none\.h5: no such file \(made by clog run\)")
        self.refuses(lambda: clogflow.Flow(self.folder / "none.h5"), r"no such file \(made by clog map\)")
        self.refuses(lambda: clogflow.Run(self.folder), r"a folder, not a file \(clogflow\.Ensemble")
        self.refuses(lambda: clogflow.Ensemble(self.folder / "none"), r"no such folder \(made by clog run")
        self.refuses(lambda: clogflow.Ensemble(self.folder / "case/system"), r"no run_\*\.h5 here or one folder below")
        self.refuses(lambda: clogflow.Statistics(self.folder), r"stats\.json: no such file \(made by clog stats")

    def test_what_is_of_another_kind(self):
        self.refuses(lambda: clogflow.Run(self.folder / "scene.toml"), r"scene\.toml: no HDF5 file$")
        (self.folder / "empty.h5").write_bytes(b"")
        self.refuses(lambda: clogflow.Run(self.folder / "empty.h5"), r"no HDF5 file \(it is empty\)")
        self.refuses(lambda: clogflow.Run(self.folder / "flow.h5"), r'"clogflow flow" file.*open it with clogflow\.Flow')
        self.refuses(lambda: clogflow.Flow(self.good), r'"clogflow run" file.*open it with clogflow\.Run')
        with h5py.File(self.folder / "other.h5", "w") as file:
            file["x"] = 1
        self.refuses(lambda: clogflow.Run(self.folder / "other.h5"), "an HDF5 file of another program")

    def test_another_version(self):
        def newer(file):
            file.attrs["version"] = 2
        file = self.changed("newer.h5", newer)
        self.refuses(lambda: clogflow.Run(file), r'version 2 of "clogflow run"; this package reads version 1')

    def test_cut_short_at_any_place(self):
        whole = self.good.read_bytes()
        for share in (0.1, 0.5, 0.9, 0.999):
            cut = self.folder / "cut.h5"
            cut.write_bytes(whole[:int(share * len(whole))])
            self.refuses(lambda cut=cut: clogflow.Run(cut), r"cut\.h5: cut short")

    def test_a_column_that_is_missing_or_of_another_unit_or_length(self):
        def without(file):
            del file["passages/y"]

        def other_unit(file):
            file["passages/y"].attrs["unit"] = np.bytes_("mm")

        def longer(file):
            del file["series/count"]
            file.create_dataset("series/count", data=np.zeros(99, np.int64)).attrs["unit"] = np.bytes_("1")

        self.refuses(lambda: clogflow.Run(self.changed("a.h5", without)).passages, "/passages/y is missing")
        self.refuses(lambda: clogflow.Run(self.changed("b.h5", other_unit)).passages, "/passages/y has the unit 'mm', not 'm'")
        self.refuses(lambda: clogflow.Run(self.changed("c.h5", longer)).series, "columns of /series have different lengths")

    def test_a_flipped_bit_in_the_data(self):
        """Large arrays carry checksums."""
        many = clogflow.run(self.folder / "scene.toml", self.folder / "many", seeds=3, flow=self.folder / "flow.h5",
                            set={"output.snapshot_interval": "20 us", "output.checkpoint_interval": "60 s"}).runs[0].path
        damaged = self.folder / "damaged.h5"
        content = bytearray(many.read_bytes())
        with h5py.File(many) as file:
            place = file["snapshots/position"].id.get_chunk_info(0).byte_offset
        content[place + 20] ^= 1
        damaged.write_bytes(content)
        self.refuses(lambda: clogflow.Run(damaged).snapshots[0], "damaged")


if __name__ == "__main__":
    unittest.main()
