"""What `clog export` writes is what the run file holds: read by VTK's own readers and by a reader of extended XYZ."""

import ast
import importlib.util
import pathlib
import re
import shutil
import subprocess
import unittest
import xml.etree.ElementTree

import fixtures
import h5py
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOHDF import vtkHDFReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import clogflow

ARRAYS = {"radius [m]": "radius", "velocity [m/s]": "velocity", "spin [rad/s]": "spin", "force [N]": "force",
          "torque [N m]": "torque", "id": "id"}
XYZ = {"species": (0, 1), "pos": (1, 3), "id": (4, 1), "radius": (5, 1), "velo": (6, 3), "omega": (9, 3), "force": (12, 3), "torque": (15, 3)}

ELEMENTS = ["H", "He", "Li", "Be", "B"]  # whose number is that of the species
# https://github.com/libAtoms/extxyz: what a plain value, a quoted one and numbers may look like.
PAIR = re.compile(r'([A-Za-z_][\w-]*)=("(?:[^"\\\n]|\\.)*"|[^\s=",\[\]{}\\]+)(?: |$)')
KINDS = {"S": r"\S+", "I": r"[+-]?\d+", "R": r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eEdD][+-]?\d+)?", "L": r"[TF]"}

LABORATORY = """
[geometry]
stl = "shape.stl"
stl_unit = "1 um"
[particles]
diameter = "50 um"
density = "1062 kg/m3"
initial = "places.csv"
[contact]
youngs_modulus = "3 MPa"
poisson_ratio = 0.35
[time]
end = "10 us"
step = "1e-6 s"
[output]
snapshot_interval = "5 us"
series_interval = "5 us"
"""


def clog(*words, **options):
    return subprocess.run([fixtures.PROGRAM, *words], cwd=fixtures.folder(), capture_output=True, text=True, check=False, **options)


def poly_data(file):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(file))
    reader.Update()
    assert reader.GetErrorCode() == 0, file
    return reader.GetOutput()


def arrays_of(data):
    points = data.GetPointData()
    return {points.GetArrayName(k): vtk_to_numpy(points.GetArray(k)) for k in range(points.GetNumberOfArrays())}


def frames(file):
    """[(attributes of the second line, table of numbers)] of an extended XYZ file."""
    lines, found = file.read_text().splitlines(), []
    while lines:
        count, comment = int(lines[0]), lines[1]
        attributes = {key: quoted or plain for key, quoted, plain in re.findall(r'(\w+)=(?:"([^"]*)"|(\S+))', comment)}
        rows = [[ELEMENTS.index(symbol) + 1, *numbers] for symbol, *numbers in map(str.split, lines[2:2 + count])]
        found.append((attributes, np.array(rows, float).reshape(count, 18)))
        lines = lines[2 + count:]
    return found


class OfContacts(unittest.TestCase):
    def test_a_line_a_contact_from_centre_to_centre_or_to_the_wall(self):
        run = clogflow.Run(fixtures.touching())
        done = clog("export", run.path, "--out", "exported_contacts", "--format", "vtk")
        self.assertEqual(done.returncode, 0, done.stderr)
        out = fixtures.folder() / "exported_contacts"
        sets = xml.etree.ElementTree.parse(out / "run_0003_contacts.pvd").getroot().findall("Collection/DataSet")
        self.assertEqual([float(entry.get("timestep")) for entry in sets], list(run.snapshots.times))
        k = max(range(len(sets)), key=lambda k: len(run.snapshots[k].contacts))
        snapshot = run.snapshots[k]
        contacts, data = snapshot.contacts, poly_data(out / sets[k].get("file"))
        arrays, points = arrays_of(data), vtk_to_numpy(data.GetPoints().GetData()).reshape(-1, 2, 3)
        self.assertEqual((data.GetNumberOfLines(), data.GetNumberOfVerts(), data.GetNumberOfPolys()), (len(contacts), 0, 0))
        np.testing.assert_array_equal(arrays["id"].reshape(-1, 2), np.stack([contacts.a, contacts.b], axis=1))
        np.testing.assert_array_equal(arrays["force [N]"].reshape(-1, 2, 3)[:, 1], contacts.force)
        np.testing.assert_allclose(arrays["normal force [N]"].reshape(-1, 2)[:, 0], contacts.normal_force, rtol=1e-5)
        a = np.searchsorted(snapshot.id, contacts.a)
        np.testing.assert_array_equal(points[:, 0], snapshot.position[a])
        pairs = contacts.b >= 0
        np.testing.assert_array_equal(points[pairs, 1], snapshot.position[np.searchsorted(snapshot.id, contacts.b[pairs])])
        np.testing.assert_allclose(np.linalg.norm(points[~pairs, 1] - points[~pairs, 0], axis=1), snapshot.radius[a][~pairs], rtol=1e-6)
        self.assertGreater(np.count_nonzero(~pairs), 2)


class OfARun(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.run_file = fixtures.folder() / "runs/run_0003.h5"
        cls.run_data = clogflow.Run(cls.run_file)
        cls.out = fixtures.folder() / "exported"
        cls.done = clog("export", "runs/run_0003.h5", "--flow", "flow.h5", "--out", "exported")

    def test_it_names_the_files_to_open(self):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)
        self.assertEqual([pathlib.Path(line).name for line in self.done.stdout.split()],
                         ["run_0003.pvd", "run_0003.xyz", "walls.vtp", "flow.hdf", "show_in_paraview.py"])

    def test_vtk_reads_every_number_of_every_snapshot(self):
        sets = xml.etree.ElementTree.parse(self.out / "run_0003.pvd").getroot().findall("Collection/DataSet")
        self.assertEqual([float(entry.get("timestep")) for entry in sets], list(self.run_data.snapshots.times))
        self.assertGreater(len(sets), 1)
        for entry, snapshot in zip(sets, self.run_data.snapshots):
            data = poly_data(self.out / entry.get("file"))
            arrays = arrays_of(data)
            self.assertEqual(set(arrays), set(ARRAYS))
            for name, member in ARRAYS.items():
                self.assertTrue(np.array_equal(arrays[name], getattr(snapshot, member)), name)
            self.assertTrue(np.array_equal(vtk_to_numpy(data.GetPoints().GetData()), snapshot.position))
            self.assertEqual(data.GetNumberOfVerts(), len(snapshot))  # so that points are drawn without a filter
            self.assertEqual(data.GetFieldData().GetArray("TimeValue").GetValue(0), snapshot.time)

    def test_the_walls_enclose_the_particles_and_hold_those_of_the_flow(self):
        walls = poly_data(self.out / "walls.vtp")
        corners = vtk_to_numpy(walls.GetPoints().GetData()).reshape(-1, 3, 3)
        self.assertEqual(walls.GetNumberOfPolys(), len(corners))
        ours = {tuple(np.sort(np.round(1e9 * triangle), axis=0).ravel()) for triangle in corners}
        theirs = {tuple(np.sort(np.round(1e9 * triangle), axis=0).ravel()) for triangle in clogflow.Flow(fixtures.folder() / "flow.h5").walls}
        self.assertLess(len(theirs - ours), len(theirs))  # the flow's channel may be longer
        position = self.run_data.snapshots[-1].position
        self.assertTrue(np.all(position[:, 1:] > corners.min(axis=(0, 1))[1:]))
        self.assertTrue(np.all(position[:, 1:] < corners.max(axis=(0, 1))[1:]))

    def test_vtk_reads_the_flow_under_its_new_name(self):
        reader = vtkHDFReader()
        reader.SetFileName(str(self.out / "flow.hdf"))
        self.assertTrue(reader.CanReadFile(str(self.out / "flow.hdf")))
        reader.Update()
        image, flow = reader.GetOutput(), clogflow.Flow(fixtures.folder() / "flow.h5")
        self.assertEqual(image.GetDimensions(), flow.points)
        arrays = arrays_of(image)
        self.assertTrue(np.array_equal(arrays["U"].reshape(flow.velocity.shape), flow.velocity))
        self.assertTrue(np.array_equal(arrays["solid"].reshape(flow.solid.shape), flow.solid))
        self.assertTrue(np.array_equal(clogflow.Flow(self.out / "flow.hdf").velocity, flow.velocity))

    def test_extended_xyz_has_every_digit_and_a_box_around_all(self):
        read = frames(self.out / "run_0003.xyz")
        self.assertEqual(len(read), len(self.run_data.snapshots))
        for (attributes, table), snapshot in zip(read, self.run_data.snapshots):
            properties = attributes["Properties"].split(":")
            columns, at = {}, 0
            for name, width in zip(properties[::3], map(int, properties[2::3])):
                columns[name], at = (at, width), at + width
            self.assertEqual(columns, XYZ)
            self.assertEqual(float(attributes["Time"]), snapshot.time)
            self.assertEqual(attributes["pbc"], "F F F")
            for name, member in (("pos", "position"), ("id", "id"), ("radius", "radius"), ("velo", "velocity"), ("omega", "spin"),
                                 ("force", "force"), ("torque", "torque")):
                first, width = columns[name]
                expected = getattr(snapshot, member).reshape(len(snapshot), width)
                self.assertTrue(np.array_equal(table[:, first:first + width], expected), name)
            self.assertTrue(np.all(table[:, 0] == 1))
            size = np.array(attributes["Lattice"].split(), float).reshape(3, 3)
            origin = np.array(attributes["Origin"].split(), float)
            self.assertTrue(np.array_equal(size, np.diag(np.diag(size))))
            self.assertTrue(np.all(snapshot.position - snapshot.radius[:, None] >= origin - 1e-15))
            self.assertTrue(np.all(snapshot.position + snapshot.radius[:, None] <= origin + np.diag(size) + 1e-15))
            self.assertEqual((attributes["Lattice"], attributes["Origin"]), (read[0][0]["Lattice"], read[0][0]["Origin"]))

    def test_extended_xyz_keeps_to_its_grammar(self):
        lines = (self.out / "run_0003.xyz").read_text().split("\n")
        self.assertEqual(lines.pop(), "")
        while lines:
            self.assertRegex(lines[0], r"^\d+$")
            pairs = PAIR.findall(lines[1])
            self.assertEqual("".join(f"{key}={value} " for key, value in pairs), lines[1] + " ")  # nothing between them
            named = dict(pairs)
            self.assertEqual(len(named), len(pairs))
            self.assertRegex(named["Properties"], r"^\w+:[SIRL]:[1-9]\d*(:\w+:[SIRL]:[1-9]\d*)*$")
            self.assertEqual(len(named["Lattice"].strip('"').split()), 9)
            words = named["Properties"].split(":")
            row = re.compile(" ".join(" ".join([KINDS[kind]] * int(count)) for kind, count in zip(words[1::3], words[2::3])))
            count = int(lines[0])
            self.assertGreater(count, 0)
            for line in lines[2:2 + count]:
                self.assertIsNotNone(row.fullmatch(line), line)
            lines = lines[2 + count:]

    @unittest.skipIf(importlib.util.find_spec("ase") is None, "no ase (python3-ase)")
    def test_ase_reads_extended_xyz(self):
        import ase.io
        read = ase.io.read(self.out / "run_0003.xyz", index=":", format="extxyz")
        self.assertEqual(len(read), len(self.run_data.snapshots))
        for atoms, snapshot in zip(read, self.run_data.snapshots):
            self.assertTrue(np.array_equal(atoms.positions, snapshot.position))
            self.assertTrue(np.array_equal(atoms.arrays["velo"], snapshot.velocity))
            self.assertTrue(np.array_equal(atoms.arrays["radius"], snapshot.radius))
            self.assertTrue(np.array_equal(atoms.numbers, np.ones(len(snapshot))))
            self.assertEqual(atoms.info["Time"], snapshot.time)

    def test_the_script_for_paraview_knows_its_folder(self):
        odd = fixtures.folder() / 'a "b" \\ µ'
        self.assertEqual(clog("export", "runs/run_0003.h5", "--format", "vtk", "--out", odd.name).returncode, 0)
        line = next(line for line in (odd / "show_in_paraview.py").read_text().splitlines() if line.startswith("WRITTEN_TO"))
        self.assertEqual(ast.literal_eval(line.split(" = ")[1].split("  #")[0]), str(odd))

    def test_a_format_alone(self):
        self.assertEqual(clog("export", "runs/run_0003.h5", "--format", "xyz", "--out", "ovito").returncode, 0)
        self.assertEqual([file.name for file in (fixtures.folder() / "ovito").iterdir()], ["run_0003.xyz"])
        self.assertEqual(clog("export", "runs/run_0003.h5", "--format", "vtk", "--no-walls", "--out", "paraview").returncode, 0)
        self.assertEqual({file.name for file in (fixtures.folder() / "paraview").iterdir()}, {"run_0003", "run_0003.pvd", "show_in_paraview.py"})

    def test_from_python(self):
        files = clogflow.export(self.run_data, fixtures.folder() / "by_python", format="vtk", walls=False, flow=fixtures.folder() / "flow.h5")
        self.assertEqual([file.name for file in files], ["run_0003.pvd", "flow.hdf", "show_in_paraview.py"])
        self.assertTrue(all(file.is_file() for file in files))
        with self.assertRaisesRegex(clogflow.ProgramError, "a flow has no particles"):
            clogflow.export(clogflow.Flow(fixtures.folder() / "flow.h5"), fixtures.folder() / "by_python", format="xyz")

    def test_a_flow_alone(self):
        done = clog("export", "flow.h5", "--out", "flow_alone")
        self.assertEqual(done.returncode, 0, done.stderr)
        walls = vtk_to_numpy(poly_data(fixtures.folder() / "flow_alone/walls.vtp").GetPoints().GetData())
        self.assertTrue(np.array_equal(walls.reshape(-1, 3, 3), clogflow.Flow(fixtures.folder() / "flow.h5").walls))

    def test_species_where_particles_differ_and_a_frame_without_any(self):
        run = clogflow.run(fixtures.folder() / "scene.toml", fixtures.folder() / "of_two_sizes", seeds=3, flow=fixtures.folder() / "flow.h5",
                           set={"inlet.start": "empty", "unclog.protocol": "none", "particles.size_spread": 0.05, "time.end": "10 ms"}).runs[0]
        with h5py.File(run.path, "r+") as file:  # a frame of no particle before the others
            for name in ("time", "first"):
                unit, values = file[f"snapshots/{name}"].attrs["unit"], file[f"snapshots/{name}"][:]
                del file[f"snapshots/{name}"]
                file.create_dataset(f"snapshots/{name}", data=np.append(values[:1], values)).attrs["unit"] = unit
        run = clogflow.Run(run.path)
        self.assertEqual(clog("export", run.path, "--out", "species").returncode, 0)
        self.assertEqual(len(run.snapshots[0]), 0)
        self.assertGreater(len(run.snapshots[-1]), 1)
        self.assertEqual(poly_data(fixtures.folder() / "species/run_0003/snapshot_00000.vtp").GetNumberOfPoints(), 0)
        last = arrays_of(poly_data(fixtures.folder() / f"species/run_0003/snapshot_{len(run.snapshots) - 1:05}.vtp"))
        self.assertTrue(np.array_equal(last["species"], run.snapshots[-1].species))
        self.assertGreater(np.ptp(last["radius [m]"]), 0)
        read = frames(fixtures.folder() / "species/run_0003.xyz")
        self.assertEqual([len(table) for _, table in read], [len(snapshot) for snapshot in run.snapshots])
        self.assertTrue(np.array_equal(read[-1][1][:, 0], run.snapshots[-1].species + 1))


class Refusals(unittest.TestCase):
    def refused(self, pattern, *words, status=1, **options):
        done = clog("export", *words, **options)
        self.assertEqual(done.returncode, status, done.stderr)
        self.assertRegex(done.stderr, pattern)
        if status == 1:
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)

    def test_what_cannot_be_exported(self):
        folder = fixtures.folder()
        (folder / "cut.h5").write_bytes((folder / "runs/run_0003.h5").read_bytes()[:20000])
        self.refused(r"none\.h5", "none.h5", "--out", "refused")
        self.refused(r"scene\.toml \(not an HDF5 file", "scene.toml", "--out", "refused")
        self.refused(r"cut\.h5 \(", "cut.h5", "--out", "refused")
        self.refused("a flow has no particles for --format xyz", "flow.h5", "--format", "xyz", "--out", "refused")
        self.refused(r"--flow flow\.h5 \(goes with a run file", "flow.h5", "--flow", "flow.h5", "--out", "refused")
        self.refused("--format", "runs/run_0003.h5", "--format", "gltf", "--out", "refused", status=2)
        self.assertFalse((folder / "refused").exists())
        self.refused("scene.toml/x/run_0003: cannot be made", "runs/run_0003.h5", "--out", "scene.toml/x")

    def test_the_flow_of_another_run(self):
        other = fixtures.folder() / "other_flow.h5"
        shutil.copy(fixtures.folder() / "flow.h5", other)
        with h5py.File(other, "r+") as file:
            hash_ = file["provenance/hash"][()]
            del file["provenance/hash"]
            file["provenance/hash"] = np.bytes_(hash_[::-1])
        self.refused(r"--flow other_flow\.h5: not the flow of this run", "runs/run_0003.h5", "--flow", "other_flow.h5", "--out", "refused")

    def test_a_run_without_snapshots(self):
        file = fixtures.folder() / "bare.h5"
        shutil.copy(fixtures.folder() / "runs/run_0003.h5", file)
        with h5py.File(file, "r+") as opened:
            for name, dataset in list(opened["snapshots"].items()):
                unit, values = dataset.attrs["unit"], dataset[:0]
                del opened[f"snapshots/{name}"]
                opened.create_dataset(f"snapshots/{name}", data=values).attrs["unit"] = unit
        self.refused(r"bare: no snapshots to export \(output\.snapshot_interval\)", "bare.h5", "--out", "refused")

    def test_walls_whose_file_is_gone(self):
        """A laboratory's STL file stands beside its scene, not in the run file."""
        folder = fixtures.folder()
        subprocess.run([fixtures.PROGRAM, "walls", "scene.toml", "--out", "shape.stl"], cwd=folder, check=True, capture_output=True)
        (folder / "places.csv").write_text("x,y,z\n0,0,5e-5\n")
        (folder / "laboratory.toml").write_text(LABORATORY)
        done = clog("run", "laboratory.toml", "--seeds", "3", "--out", "of_stl")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(clog("export", "of_stl/run_0003.h5", "--out", "of_stl").returncode, 0)
        (folder / "shape.stl").unlink()
        self.refused(r"shape\.stl.*\(the walls of the run: --no-walls leaves them out\)", "of_stl/run_0003.h5", "--out", "gone")
        self.assertEqual(clog("export", "of_stl/run_0003.h5", "--no-walls", "--out", "gone").returncode, 0)

    def test_a_full_disk(self):
        """Files that may grow to a kilobyte only, as on one."""
        done = subprocess.run(["/bin/sh", "-c", f"trap '' XFSZ; ulimit -f 1; exec {fixtures.PROGRAM} export runs/run_0003.h5 --out full"],
                              cwd=fixtures.folder(), capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"^clog: full/run_0003/snapshot_00000\.vtp \(cannot be written: .*\n$")
        self.assertEqual([file for file in (fixtures.folder() / "full").rglob("*") if file.is_file()], [])


if __name__ == "__main__":
    unittest.main()
