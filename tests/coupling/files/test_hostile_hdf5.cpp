// Flow and run files that were made to reach beyond themselves: each is refused in a line, at once.
#include <hdf5.h>
#include <sys/stat.h>

#include <functional>
#include <random>

#include <gmock/gmock.h>

#include "tests/coupling/openfoam/sample_files.hpp"
#include "tests/coupling/refusal.hpp"

namespace clogflow {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* column = "/series/kinetic_energy";

struct Stored {
  hid_t list;
  std::vector<hsize_t> extent{3};
};

// A dataset in the place of another one, with its unit.
void replace(hid_t file, const char* path, const Stored& stored) {
  ASSERT_GE(H5Ldelete(file, path, H5P_DEFAULT), 0);
  // Able to grow, so that a piece may be larger than the whole.
  const std::vector<hsize_t> most(stored.extent.size(), H5S_UNLIMITED);
  const bool grows = H5Pget_layout(stored.list) == H5D_CHUNKED;
  const hid_t space =
      H5Screate_simple(static_cast<int>(stored.extent.size()), stored.extent.data(), grows ? most.data() : nullptr);
  const hid_t data = H5Dcreate2(file, path, H5T_IEEE_F64LE, space, H5P_DEFAULT, stored.list, H5P_DEFAULT);
  ASSERT_GE(data, 0);
  const hid_t text = H5Tcopy(H5T_C_S1);
  const hid_t unit = H5Acreate2(data, "unit", text, H5Screate(H5S_SCALAR), H5P_DEFAULT, H5P_DEFAULT);
  ASSERT_GE(H5Awrite(unit, text, "J"), 0);
  H5Aclose(unit);
  H5Dclose(data);
}

std::filesystem::path changed_run(const std::string& name, const std::function<void(hid_t)>& change) {
  const auto path = temporary(name);
  write_run_file(sample_run(), path);
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  EXPECT_GE(file, 0);
  change(file);
  H5Fclose(file);
  return path;
}

std::string read_refusal(const std::filesystem::path& file) {
  return refusal([&] { read_run_file(file); });
}

void expect_refused(const std::string& name, const std::function<void(hid_t)>& change, const std::string& reason) {
  const auto file = changed_run(name, change);
  EXPECT_THAT(read_refusal(file), AllOf(StartsWith(file.string() + ": " + column), HasSubstr(reason)));
}

constexpr const char* not_followed = "links are not followed";
constexpr const char* elsewhere = "kept in another file";

TEST(HostileHdf5, ExternalStorageIsNotRead) {
  const auto secret = temporary("secret");
  std::ofstream(secret) << "twenty-four bytes of it!";
  expect_refused(
      "external.h5",
      [&](hid_t file) {
        const hid_t list = H5Pcreate(H5P_DATASET_CREATE);
        H5Pset_external(list, secret.c_str(), 0, 24);
        replace(file, column, {.list = list});
      },
      elsewhere);
}

TEST(HostileHdf5, ExternalStorageInAPipeDoesNotWait) {
  const auto pipe = temporary("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  expect_refused(
      "external_pipe.h5",
      [&](hid_t file) {
        const hid_t list = H5Pcreate(H5P_DATASET_CREATE);
        H5Pset_external(list, pipe.c_str(), 0, 24);
        replace(file, column, {.list = list});
      },
      elsewhere);
}

TEST(HostileHdf5, AVirtualDatasetIsNotRead) {
  write_run_file(sample_run(), temporary("source.h5"));
  expect_refused(
      "virtual.h5",
      [&](hid_t file) {
        const hsize_t extent = 3;
        const hid_t space = H5Screate_simple(1, &extent, nullptr), list = H5Pcreate(H5P_DATASET_CREATE);
        H5Pset_virtual(list, space, temporary("source.h5").c_str(), column, space);
        replace(file, column, {.list = list});
      },
      elsewhere);
}

TEST(HostileHdf5, LinksAreNotFollowed) {
  write_run_file(sample_run(), temporary("target.h5"));
  expect_refused(
      "link.h5",
      [&](hid_t file) {
        H5Ldelete(file, column, H5P_DEFAULT);
        H5Lcreate_external(temporary("target.h5").c_str(), column, file, column, H5P_DEFAULT, H5P_DEFAULT);
      },
      not_followed);
  expect_refused(
      "soft.h5",
      [&](hid_t file) {
        H5Ldelete(file, column, H5P_DEFAULT);
        H5Lcreate_soft("/series/drag_work", file, column, H5P_DEFAULT, H5P_DEFAULT);
      },
      not_followed);
}

TEST(HostileHdf5, LinksOfGroupsAreNotFollowed) {
  write_run_file(sample_run(), temporary("target.h5"));
  const auto file = changed_run("group.h5", [&](hid_t id) {
    H5Ldelete(id, "/series", H5P_DEFAULT);
    H5Lcreate_external(temporary("target.h5").c_str(), "/series", id, "/series", H5P_DEFAULT, H5P_DEFAULT);
  });
  EXPECT_THAT(read_refusal(file), AllOf(StartsWith(file.string() + ": /series ("), HasSubstr(not_followed)));
}

// An image of a flow file: the attributes of a group behind a link are no exception.
TEST(HostileHdf5, AttributesBehindALink) {
  const auto path = temporary("flow.h5");
  write_flow_grid(sample_grid(), temporary("other.h5"));
  write_flow_grid(sample_grid(), path);
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  H5Ldelete(file, "/VTKHDF", H5P_DEFAULT);
  H5Lcreate_external(temporary("other.h5").c_str(), "/VTKHDF", file, "/VTKHDF", H5P_DEFAULT, H5P_DEFAULT);
  H5Fclose(file);
  EXPECT_THAT(refusal([&] { read_flow_grid(path); }), HasSubstr(not_followed));
}

hid_t chunked(std::vector<hsize_t> chunk) {
  const hid_t list = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(list, static_cast<int>(chunk.size()), chunk.data());
  return list;
}

TEST(HostileHdf5, OnlyOurFilters) {
  expect_refused(
      "nbit.h5",
      [](hid_t file) {
        const hid_t list = chunked({3});
        H5Pset_nbit(list);
        replace(file, column, {.list = list});
      },
      "only deflate, shuffle and fletcher32");
  expect_refused(
      "twice.h5",
      [](hid_t file) {
        const hid_t list = chunked({3});
        H5Pset_deflate(list, 9);
        H5Pset_deflate(list, 9);
        replace(file, column, {.list = list});
      },
      "packed twice");
}

TEST(HostileHdf5, PiecesOutOfProportion) {
  expect_refused(
      "piece.h5", [](hid_t file) { replace(file, column, {.list = chunked({100'000'000})}); },
      "pieces of over 256 MiB");
}

/// Columns that all name the same zeros, which take a thousandth of what they unpack to.
TEST(HostileHdf5, ManyNamesOfTheSameBytes) {
  constexpr hsize_t count = 4'000'000;
  const auto file = changed_run("many.h5", [](hid_t id) {
    const hid_t list = chunked({count / 4});
    H5Pset_deflate(list, 9);
    replace(id, column, {.list = list, .extent = {count}});
    const hid_t data = H5Dopen2(id, column, H5P_DEFAULT);
    const std::vector<double> zeros(count);
    ASSERT_GE(H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, zeros.data()), 0);
    H5Dclose(data);
    for (const char* other : {"/series/elastic_energy", "/series/drag_work", "/series/dissipated"}) {
      H5Ldelete(id, other, H5P_DEFAULT);
      H5Lcreate_hard(id, column, id, other, H5P_DEFAULT, H5P_DEFAULT);
    }
  });
  ASSERT_LT(std::filesystem::file_size(file), 80'000u);
  EXPECT_THAT(read_refusal(file), AllOf(StartsWith(file.string()), HasSubstr("unpacks to more than")));
}

std::filesystem::path run_with_record(const std::string& name, const std::string& record) {
  return changed_run(name, [&](hid_t file) {
    H5Ldelete(file, "/provenance/record", H5P_DEFAULT);
    const hid_t text = H5Tcopy(H5T_C_S1);
    H5Tset_size(text, record.size());
    const hid_t space = H5Screate(H5S_SCALAR);
    const hid_t data = H5Dcreate2(file, "/provenance/record", text, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    ASSERT_GE(H5Dwrite(data, text, H5S_ALL, H5S_ALL, H5P_DEFAULT, record.data()), 0);
    H5Dclose(data);
  });
}

TEST(HostileHdf5, ARecordNestedDeep) {
  std::string record;
  for (int k = 0; k < 100'000; ++k) record += "[";
  for (int k = 0; k < 100'000; ++k) record += "]";
  for (const std::string& text : {record, "{\"host\": " + record + "}"}) {
    const auto file = run_with_record("deep.h5", text);
    EXPECT_THAT(read_refusal(file), AllOf(StartsWith(file.string()), HasSubstr("nested too deep")));
  }
}

TEST(HostileHdf5, ARecordOfAnotherKind) {
  for (const auto& [record, reason] : {std::pair("[1, 2]", "/provenance/record is no JSON object"),
                                       {"{\"wall_time_s\": \"long\"}", "wall_time_s is no number"},
                                       {"{\"particle_steps\": null}", "particle_steps is no number"},
                                       {"{\"inputs_hash\": 1}", "inputs_hash is no text"},
                                       {"{\"inputs", "is no JSON"}}) {
    const auto file = run_with_record("kind.h5", record);
    EXPECT_THAT(read_refusal(file), AllOf(StartsWith(file.string()), HasSubstr(reason)));
  }
}

TEST(HostileHdf5, PipesAndDevicesAreNotOpened) {
  const auto pipe = temporary("pipe.h5");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(read_refusal(pipe), HasSubstr("pipe.h5 (not a file)"));
  EXPECT_THAT(read_refusal("/dev/zero"), HasSubstr("/dev/zero (not a file)"));
}

}  // namespace
}  // namespace clogflow
