// run_NNNN.h5: the way there and back, the index of its snapshots, and every refusal.
#include <cstdlib>
#include <limits>

#include <gmock/gmock.h>

#include "coupling/files/hdf5_file.hpp"
#include "tests/coupling/openfoam/sample_files.hpp"
#include "tests/coupling/refusal.hpp"

namespace clogflow {
namespace {

using testing::HasSubstr;

TEST(RunFile, ThereAndBack) {
  const RunData run = sample_run();
  const auto file = temporary(run_file_name(7));
  EXPECT_EQ(file.filename(), "run_0007.h5");
  EXPECT_EQ(run_file_name(123456), "run_123456.h5");
  write_run_file(run, file);
  const RunData read = read_run_file(file);
  EXPECT_EQ(read.seed, run.seed);
  EXPECT_EQ(read.scene_text, run.scene_text);
  EXPECT_EQ(read.record, run.record);
  EXPECT_EQ(read.end_time, run.end_time);
  EXPECT_EQ(read.passages.time, run.passages.time);
  EXPECT_EQ(read.passages.id, run.passages.id);
  EXPECT_EQ(read.passages.y, run.passages.y);
  EXPECT_EQ(read.passages.z, run.passages.z);
  EXPECT_EQ(read.passages.friction_off, run.passages.friction_off);
  EXPECT_EQ(read.releases.off, run.releases.off);
  EXPECT_EQ(read.releases.on, run.releases.on);
  EXPECT_EQ(read.releases.largest_speed, run.releases.largest_speed);
  EXPECT_EQ(read.releases.position, run.releases.position);
  EXPECT_EQ(read.series.time, run.series.time);
  EXPECT_EQ(read.series.count, run.series.count);
  EXPECT_EQ(read.series.porosity, run.series.porosity);
  EXPECT_EQ(read.series.wall_contacts, run.series.wall_contacts);
  EXPECT_EQ(read.series.speed_q99, run.series.speed_q99);
  ASSERT_EQ(read.snapshots.size(), run.snapshots.size());
  for (std::size_t i = 0; i < run.snapshots.size(); ++i) {
    EXPECT_EQ(read.snapshots[i].time, run.snapshots[i].time);
    EXPECT_EQ(read.snapshots[i].id, run.snapshots[i].id);
    EXPECT_EQ(read.snapshots[i].radius, run.snapshots[i].radius);
    EXPECT_EQ(read.snapshots[i].position, run.snapshots[i].position);
    EXPECT_EQ(read.snapshots[i].velocity, run.snapshots[i].velocity);
    EXPECT_EQ(read.snapshots[i].spin, run.snapshots[i].spin);
    EXPECT_EQ(read.snapshots[i].force, run.snapshots[i].force);
    EXPECT_EQ(read.snapshots[i].torque, run.snapshots[i].torque);
  }
}

TEST(RunFile, EmptyRun) {
  const auto file = temporary("empty.h5");
  write_run_file(RunData{}, file);
  const RunData read = read_run_file(file);
  EXPECT_TRUE(read.passages.time.empty() && read.series.porosity.empty() && read.snapshots.empty());
  EXPECT_FALSE(std::filesystem::exists(temporary("empty.xmf")));
}

TEST(RunFile, SamplesWithoutStrips) {
  RunData run = sample_run();
  for (auto& row : run.series.porosity) row.clear();
  write_run_file(run, temporary("strips.h5"));
  EXPECT_EQ(read_run_file(temporary("strips.h5")).series.porosity, run.series.porosity);
}

// The index is what ParaView reads; an independent reader of HDF5 follows its hyperslabs.
TEST(RunFile, IndexPointsAtTheSnapshots) {
  if (std::system("/usr/bin/python3 -c 'import h5py' 2> /dev/null") != 0)
    GTEST_SKIP() << "python3-h5py is not installed";
  write_run_file(sample_run(), temporary("index.h5"));
  const auto script = temporary("index_check.py");
  std::ofstream(script) << R"(
import os, sys
import xml.etree.ElementTree as tree
import h5py
folder = sys.argv[1]
frames = tree.parse(os.path.join(folder, 'index.xmf')).getroot().findall('./Domain/Grid/Grid')
assert [float(f.find('Time').get('Value')) for f in frames] == [0.0, 2.0]
def rows(item):
    slab, source = item.findall('DataItem')
    name, path = source.text.split(':')
    data = h5py.File(os.path.join(folder, name))[path]
    assert data.shape == tuple(map(int, source.get('Dimensions').split())), path
    number = list(map(int, slab.text.split()))
    rank = data.ndim
    start, stride, count = number[:rank], number[rank:2 * rank], number[2 * rank:]
    assert stride == [1] * rank and count == list(map(int, item.get('Dimensions').split()))
    return data[tuple(slice(s, s + c) for s, c in zip(start, count))]
for frame, particles in zip(frames, (2, 3)):
    assert int(frame.find('Topology').get('NumberOfElements')) == particles
    assert rows(frame.find('Geometry/DataItem'))[1].tolist() == [100.0 * particles + 10 + axis for axis in range(3)]
    values = {a.get('Name'): rows(a.find('DataItem')) for a in frame.findall('Attribute')}
    assert values['id'].tolist() == [10 * particles + i for i in range(particles)]
    assert set(values) == {'id', 'radius', 'velocity', 'spin', 'force', 'torque'}
)";
  EXPECT_EQ(std::system(fmt::format("/usr/bin/python3 {} {}", script.string(), scratch_folder().string()).c_str()), 0);
}

TEST(RunFile, EveryDatasetHasAUnit) {
  if (std::system("/usr/bin/python3 -c 'import h5py' 2> /dev/null") != 0)
    GTEST_SKIP() << "python3-h5py is not installed";
  write_run_file(sample_run(), temporary("units.h5"));
  const auto script = temporary("unit_check.py");
  std::ofstream(script) << "import sys, h5py\n"
                           "def check(name, item):\n"
                           "    if isinstance(item, h5py.Dataset) and item.dtype.kind != 'S': "
                           "assert item.attrs['unit'], name\n"
                           "h5py.File(sys.argv[1]).visititems(check)\n";
  EXPECT_EQ(std::system(fmt::format("/usr/bin/python3 {} {}", script.string(), temporary("units.h5").string()).c_str()),
            0);
}

TEST(RunFile, WriterRefuses) {
  const auto refused = [](auto change) {
    RunData run = sample_run();
    change(run);
    return refusal([&] { write_run_file(run, temporary("refused.h5")); });
  };
  EXPECT_THAT(refused([](RunData& r) { r.passages.y.pop_back(); }),
              HasSubstr("/passages/y has 1 rows (the columns before it have 2)"));
  EXPECT_THAT(refused([](RunData& r) {
                r.passages.time = {2, 1};
              }),
              HasSubstr("/passages/time is not in ascending order"));
  EXPECT_THAT(refused([](RunData& r) { r.passages.time[1] = std::numeric_limits<double>::infinity(); }),
              HasSubstr("/passages/time is not"));
  EXPECT_THAT(refused([](RunData& r) { r.series.porosity.pop_back(); }), HasSubstr("/series/porosity has 2 rows"));
  EXPECT_THAT(refused([](RunData& r) { r.series.porosity[1].pop_back(); }), HasSubstr("rows of different length"));
  EXPECT_THAT(refused([](RunData& r) { r.series.time[1] = -1; }), HasSubstr("/series/time is not in ascending order"));
  EXPECT_THAT(refused([](RunData& r) { r.end_time = std::numeric_limits<double>::quiet_NaN(); }),
              HasSubstr("/end_time is nan s (must be from 0 on)"));
  EXPECT_THAT(refused([](RunData& r) { r.end_time = -1; }), HasSubstr("/end_time is -1 s (must be from 0 on)"));
  EXPECT_THAT(refused([](RunData& r) { r.snapshots[0].force.pop_back(); }),
              HasSubstr("/snapshots/force has 5 numbers for 2 particles"));
  EXPECT_FALSE(std::filesystem::exists(temporary("refused.h5")));
}

TEST(RunFile, SeveralNecksAreAColumnAndOneIsNone) {
  RunData run = sample_run();
  const auto file = temporary("necks.h5");
  write_run_file(run, file);
  EXPECT_FALSE(Hdf5Reader(file, {.name = "clogflow run", .version = 1}).has("/passages/neck"));
  run.record.necks = 2;
  run.passages.neck = {1, 0};
  write_run_file(run, file);
  EXPECT_EQ(read_run_file(file).passages.neck, run.passages.neck);
  EXPECT_EQ(read_run_file(file).record.necks, 2);
  run.passages.neck = {1};
  EXPECT_THAT(refusal([&] { write_run_file(run, file); }), HasSubstr("/passages/neck has 1 rows"));
  run.passages.neck = {2, 0};
  EXPECT_THAT(refusal([&] { write_run_file(run, file); }), HasSubstr("names a neck beyond the 2 of the record"));
}

/// The first snapshot has a pair and a touch of the wall, the others nothing.
RunData run_with_contacts() {
  RunData run = sample_run();
  run.has_contacts = true;
  const auto& id = run.snapshots[0].id;
  run.snapshots[0].contacts = {{id[0], id[1]}, {id[1], -1}, {1, 0, 0, 0, 0, 1}, {2e-7f, 1e-8f, 0, 0, 0, 5e-8f}};
  return run;
}

TEST(RunFile, ContactsAreThereOnlyWhereTheyWereLookedAt) {
  const auto file = temporary("contacts.h5");
  write_run_file(sample_run(), file);
  EXPECT_FALSE(Hdf5Reader(file, {.name = "clogflow run", .version = 1}).has("/contacts"));
  EXPECT_FALSE(read_run_file(file).has_contacts);
  const RunData run = run_with_contacts();
  write_run_file(run, file);
  const RunData read = read_run_file(file);
  EXPECT_TRUE(read.has_contacts);
  for (std::size_t k = 0; k < run.snapshots.size(); ++k) {
    const RunData::Contacts &mine = read.snapshots[k].contacts, &theirs = run.snapshots[k].contacts;
    EXPECT_EQ(mine.a, theirs.a);
    EXPECT_EQ(mine.b, theirs.b);
    EXPECT_EQ(mine.normal, theirs.normal);
    EXPECT_EQ(mine.force, theirs.force);
  }
  EXPECT_FALSE(read_run_events(file).has_contacts);  // statistics need none
  RunData silent = sample_run();
  silent.has_contacts = true;
  write_run_file(silent, file);
  EXPECT_TRUE(read_run_file(file).has_contacts);
}

TEST(RunFile, ImpossibleContactsAreRefused) {
  const auto refused = [](auto change) {
    RunData run = run_with_contacts();
    change(run.snapshots[0].contacts);
    return refusal([&] { write_run_file(run, temporary("refused.h5")); });
  };
  EXPECT_THAT(refused([](auto& c) { c.force.pop_back(); }), HasSubstr("/contacts/force has 5 numbers for 2 contacts"));
  EXPECT_THAT(refused([](auto& c) { c.b.pop_back(); }), HasSubstr("/contacts/b has 1 numbers for 2 contacts"));
  EXPECT_THAT(refused([](auto& c) { c.b[0] = 4711; }), HasSubstr("and 4711 at 0 s, of which one is not there"));
  EXPECT_THAT(refused([](auto& c) { c.a[1] = -1; }), HasSubstr("/contacts names the particles -1 and -1"));
}

TEST(RunFile, ReaderRefusesOtherFormats) {
  const auto file = temporary("other.h5");
  Hdf5Writer(file, {.name = "clogflow run", .version = 9}).finish();
  EXPECT_THAT(refusal([&] { read_run_file(file); }),
              HasSubstr("has version 9 of \"clogflow run\", this program reads version 1"));
  Hdf5Writer(file, {.name = "clogflow run", .version = 1}).finish();
  EXPECT_THAT(refusal([&] { read_run_file(file); }), HasSubstr("/passages/time is missing"));
  Hdf5Writer unit(file, {.name = "clogflow run", .version = 1});
  unit.write("/passages/time", std::vector<double>{1}, {.unit = "ms", .shape = {}});
  unit.finish();
  EXPECT_THAT(refusal([&] { read_run_file(file); }), HasSubstr("/passages/time has the unit \"ms\" (must be \"s\")"));
}

}  // namespace
}  // namespace clogflow
