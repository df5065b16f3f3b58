// Plain text columns: what is skipped and what is refused.
#include <fstream>

#include <gmock/gmock.h>

#include "coupling/base/number_column.hpp"
#include "tests/postprocess/laws/samples.hpp"
#include "tests/scratch.hpp"

namespace clogflow::postprocess {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;

std::filesystem::path column(const char* text) {
  const auto file = scratch_folder() / "clog_column.txt";
  std::ofstream(file) << text;
  return file;
}

TEST(NumberColumn, comments_blanks_and_forms_of_a_number) {
  EXPECT_THAT(read_number_column(column("# head\n\n  1.5\n+2e-3 # two\r\n\t-4\n.5")), ElementsAre(1.5, 2e-3, -4, 0.5));
}

// /dev/zero has neither a line end nor an end.
TEST(NumberColumn, a_line_without_end_is_refused) {
  EXPECT_THAT(refusal([] { read_number_column("/dev/zero"); }),
              EndsWith("/dev/zero:1: is longer than 65536 bytes (one number a line)"));
  EXPECT_THAT(refusal([] { read_number_column(column(("1\n" + std::string(65537, '2')).c_str())); }),
              HasSubstr("clog_column.txt:2: is longer than"));
  EXPECT_THAT(read_number_column(column(std::string(65536, ' ').replace(0, 1, "3").c_str())), ElementsAre(3));
}

TEST(NumberColumn, refusals_name_file_and_line) {
  EXPECT_THAT(refusal([] { read_number_column(column("1\n# x\n2 3\n")); }),
              HasSubstr("clog_column.txt:3: '2 3' is not a number (one finite number a line)"));
  EXPECT_THAT(refusal([] { read_number_column(column("1\nabc\n")); }), HasSubstr(":2: 'abc' is not a number"));
  EXPECT_THAT(refusal([] { read_number_column(column("nan\n")); }), HasSubstr(":1: 'nan' is not a number"));
  EXPECT_THAT(refusal([] { read_number_column(column("1e999\n")); }), HasSubstr(":1: 1e999 is outside the range"));
  EXPECT_THAT(refusal([] { read_number_column(column("# only\n\n")); }), EndsWith("holds no number"));
  EXPECT_THAT(refusal([] { read_number_column("/nonexistent/file"); }), HasSubstr("/nonexistent/file: cannot be read"));
}

}  // namespace
}  // namespace clogflow::postprocess
