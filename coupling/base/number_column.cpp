// Reads a plain text column and says where it is not one.
#include "coupling/base/number_column.hpp"

#include <charconv>
#include <cmath>
#include <fstream>
#include <string>
#include <string_view>

#include "coupling/base/require.hpp"
#include "coupling/base/shown_text.hpp"

namespace clogflow::postprocess {
namespace {

/// A device or a binary file may have no line ends at all.
constexpr std::size_t longest_line = 65536;

std::string_view without_comment_and_blanks(std::string_view line) {
  constexpr std::string_view blanks = " \t\r\v\f";
  line = line.substr(0, line.find('#'));
  const auto first = line.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return line.substr(first, line.find_last_not_of(blanks) - first + 1);
}

}  // namespace

std::vector<double> read_number_column(const std::filesystem::path& file) {
  std::ifstream in(file);
  require(in.is_open() && !std::filesystem::is_directory(file), "{}: cannot be read", file.string());
  std::vector<double> values;
  std::vector<char> line(longest_line + 1);
  for (std::size_t number = 1;; ++number) {
    in.getline(line.data(), static_cast<std::streamsize>(line.size()));
    if (in.eof() && in.gcount() == 0) break;
    require(!in.fail() || in.bad(), "{}:{}: is longer than {} bytes (one number a line)", file.string(), number,
            longest_line);
    if (in.bad()) break;
    const auto length = static_cast<std::size_t>(in.gcount()) - (in.eof() ? 0 : 1);
    const auto text = without_comment_and_blanks({line.data(), length});
    if (text.empty()) continue;
    const auto digits = text.front() == '+' ? text.substr(1) : text;
    double value = 0;
    const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    require(status != std::errc::result_out_of_range, "{}:{}: {} is outside the range of a number", file.string(),
            number, shown_text(text));
    require(status == std::errc{} && end == digits.data() + digits.size() && std::isfinite(value),
            "{}:{}: '{}' is not a number (one finite number a line)", file.string(), number, shown_text(text));
    values.push_back(value);
  }
  require(!in.bad(), "{}: reading stopped by an error of the file system", file.string());
  require(!values.empty(), "{}: holds no number", file.string());
  return values;
}

}  // namespace clogflow::postprocess
