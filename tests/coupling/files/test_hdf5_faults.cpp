// Damaged, foreign and unwritable files: always one clear Error, never a crash or a guess.
#include <signal.h>
#include <sys/resource.h>

#include <random>

#include <gmock/gmock.h>

#include "coupling/files/hdf5_file.hpp"
#include "tests/coupling/openfoam/sample_files.hpp"
#include "tests/coupling/refusal.hpp"

namespace clogflow {
namespace {

using testing::AnyOf;
using testing::HasSubstr;

void write_bytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

TEST(Hdf5Faults, CutOffAnywhere) {
  write_flow_grid(sample_grid(), temporary("whole.h5"));
  const std::string whole = bytes_of(temporary("whole.h5"));
  const auto cut = temporary("cut.h5");
  std::vector<std::size_t> lengths = {0, 1, 7, 8, 48, 100, 1000, whole.size() - 1};
  for (std::size_t i = 1; i < 20; ++i) lengths.push_back(whole.size() * i / 20);
  for (const std::size_t length : lengths) {
    write_bytes(cut, whole.substr(0, length));
    EXPECT_THAT(refusal([&] { read_flow_grid(cut); }), AnyOf(HasSubstr("cut off"), HasSubstr("damaged"))) << length;
  }
}

// Every byte that is read back wrong must be noticed; a flip where nothing is stored does no harm.
TEST(Hdf5Faults, FlippedBytesAreNoticed) {
  const FlowGrid grid = sample_grid();
  write_flow_grid(grid, temporary("whole.h5"));
  const std::string whole = bytes_of(temporary("whole.h5"));
  const auto file = temporary("flipped.h5");
  std::mt19937 random(1);
  int noticed = 0;
  constexpr int tries = 400;
  for (int i = 0; i < tries; ++i) {
    std::string bytes = whole;
    char& byte = bytes[random() % bytes.size()];
    byte = static_cast<char>(byte ^ (1 << random() % 8));
    write_bytes(file, bytes);
    try {
      EXPECT_EQ(read_flow_grid(file).velocity, grid.velocity) << "flip " << i;
    } catch (const Error&) {
      ++noticed;
    }
  }
  // Nearly all of the file is checksummed data.
  EXPECT_GT(noticed, tries * 8 / 10);
}

TEST(Hdf5Faults, OtherFiles) {
  const auto file = temporary("text.h5");
  write_bytes(file, "x,y,z\n1,2,3\n");
  EXPECT_THAT(refusal([&] { read_flow_grid(file); }), HasSubstr("not an HDF5 file, or cut off"));
  EXPECT_THAT(refusal([] { read_flow_grid("nowhere.h5"); }), HasSubstr("nowhere.h5 (no such file)"));
  EXPECT_THAT(refusal([] { read_flow_grid("/"); }), HasSubstr("not a file"));
  write_flow_grid(sample_grid(), file);
  EXPECT_THAT(refusal([&] { read_run_file(file); }),
              HasSubstr("is a \"clogflow flow\" file, a \"clogflow run\" file is needed"));
}

TEST(Hdf5Faults, WrongKindsOfData) {
  const FileFormat format{.name = "test", .version = 1};
  const auto file = temporary("kinds.h5");
  Hdf5Writer out(file, format);
  out.write("/real", std::vector<double>{1}, {.unit = "m", .shape = {}});
  out.write("/whole", std::vector<std::int64_t>{1}, {.unit = "1", .shape = {}});
  out.write_text("/text", "words");
  EXPECT_THAT(refusal([&] { out.write("/bare", std::vector<double>{1}, {.unit = "", .shape = {}}); }),
              HasSubstr("/bare: no unit given"));
  EXPECT_THAT(refusal([&] { out.write("/shape", std::vector<double>{1}, {.unit = "m", .shape = {2}}); }),
              HasSubstr("do not fill its shape"));
  EXPECT_THAT(refusal([&] { out.write("/real", std::vector<double>{1}, {.unit = "m", .shape = {}}); }),
              HasSubstr("/real: cannot be written"));
  out.finish();
  const Hdf5Reader in(file, format);
  EXPECT_THAT(refusal([&] { in.read<double>("/whole", "1"); }), HasSubstr("/whole (must hold floating-point numbers"));
  EXPECT_THAT(refusal([&] { in.read<std::int64_t>("/real", "m"); }), HasSubstr("/real (must hold whole numbers"));
  EXPECT_THAT(refusal([&] { in.read<std::uint8_t>("/whole", "1"); }), HasSubstr("of at most 1 bytes"));
  EXPECT_THAT(refusal([&] { in.read<double>("/text", "1"); }), HasSubstr("/text has no attribute \"unit\""));
  EXPECT_THAT(refusal([&] { in.read<double>("/a/b/c", "1"); }), HasSubstr("/a/b/c is missing"));
  EXPECT_THAT(refusal([&] { in.read_text("/real"); }), HasSubstr("/real (must be a text of fixed length)"));
  EXPECT_THAT(refusal([&] { in.read<double>("/", "1"); }), HasSubstr("not a dataset"));
  EXPECT_EQ(in.read_text("/text"), "words");
  EXPECT_EQ(file_format(file).name, "test");
}

TEST(Hdf5Faults, NothingRemainsOfAnUnfinishedFile) {
  const auto file = temporary("unfinished.h5");
  { Hdf5Writer out(file, {.name = "test", .version = 1}); }
  EXPECT_THAT(files_in(file.parent_path()), testing::Not(testing::Contains(HasSubstr("unfinished.h5"))));
}

TEST(Hdf5Faults, AFolderThatIsNotThere) {
  EXPECT_THAT(refusal([] { write_flow_grid(sample_grid(), temporary("absent/flow.h5")); }),
              HasSubstr("absent/flow.h5 (cannot be written: No such file or directory)"));
}

// A limit on the size of files stands for a full disk: an old result survives a failed new one.
TEST(Hdf5Faults, FullDiskKeepsTheOldFile) {
  const auto file = temporary("full.h5");
  write_run_file(sample_run(), file);
  const std::string before = bytes_of(file);
  signal(SIGXFSZ, SIG_IGN);
  rlimit old{};
  getrlimit(RLIMIT_FSIZE, &old);
  const rlimit small{.rlim_cur = 10000, .rlim_max = old.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string message = refusal([&] { write_flow_grid(sample_grid(), file); });
  setrlimit(RLIMIT_FSIZE, &old);
  EXPECT_THAT(message, HasSubstr("full.h5 (cannot be written: File too large)"));
  EXPECT_EQ(bytes_of(file), before);
  EXPECT_THAT(files_in(file.parent_path()), testing::Not(testing::Contains(HasSubstr("full.h5."))));
}

}  // namespace
}  // namespace clogflow
