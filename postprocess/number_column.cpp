// Reads a plain text column and says where it is not one.
#include "postprocess/number_column.hpp"

#include <charconv>
#include <cmath>
#include <fstream>
#include <string>
#include <string_view>

#include "coupling/require.hpp"

namespace clog::postprocess {
namespace {

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
  require(in.is_open() && !std::filesystem::is_directory(file), "{}: cannot be read",
          file.string());
  std::vector<double> values;
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    const auto text = without_comment_and_blanks(line);
    if (text.empty()) continue;
    const auto digits = text.front() == '+' ? text.substr(1) : text;
    double value = 0;
    const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    require(status != std::errc::result_out_of_range, "{}:{}: {} is outside the range of a number",
            file.string(), number, text);
    require(status == std::errc{} && end == digits.data() + digits.size() && std::isfinite(value),
            "{}:{}: '{}' is not a number (one finite number a line)", file.string(), number, text);
    values.push_back(value);
  }
  require(!in.bad(), "{}: reading stopped by an error of the file system", file.string());
  require(!values.empty(), "{}: holds no number", file.string());
  return values;
}

}  // namespace clog::postprocess
