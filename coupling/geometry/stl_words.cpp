#include "coupling/geometry/stl_words.hpp"

#include <algorithm>
#include <array>
#include <sstream>

namespace clogflow {
namespace {

constexpr std::string_view blanks = " \t\r\v\f\n", byte_order_mark = "\xef\xbb\xbf";
constexpr std::array<std::string_view, 4> comments{"#", "//", ";", "!"};

char lower_case(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// Where "facet normal" begins in a line, or npos.
std::size_t find_facet(std::string_view line) {
  for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
    const std::size_t next = std::min(line.find_first_not_of(blanks, end), line.size());
    const std::size_t next_end = std::min(line.find_first_of(blanks, next), line.size());
    if (is_word(line.substr(at, end - at), "facet") && is_word(line.substr(next, next_end - next), "normal")) return at;
    at = next < line.size() ? next : std::string_view::npos;
  }
  return std::string_view::npos;
}

}  // namespace

bool is_word(std::string_view word, std::string_view lower) { return std::ranges::equal(word, lower, {}, lower_case); }

bool StlWords::next_line() {
  while (std::getline(stream_, line_)) {
    at_ = number_++ == 0 && line_.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
    at_ = line_.find_first_not_of(blanks, at_);
    if (at_ == std::string::npos) continue;
    const std::string_view rest = std::string_view(line_).substr(at_);
    if (std::ranges::none_of(comments, [&](std::string_view sign) { return rest.starts_with(sign); })) return true;
  }
  line_.clear();
  at_ = 0;
  return false;
}

std::string_view StlWords::next() {
  at_ = std::min(line_.find_first_not_of(blanks, at_), line_.size());
  if (at_ == line_.size() && !next_line()) return {};
  const std::size_t end = std::min(line_.find_first_of(blanks, at_), line_.size());
  const std::string_view word = std::string_view(line_).substr(at_, end - at_);
  at_ = end;
  return word;
}

std::string StlWords::name() {
  const std::string_view rest = std::string_view(line_).substr(at_);
  const std::string_view all = rest.substr(0, find_facet(rest));
  at_ += all.size();
  const std::size_t first = all.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return std::string(all.substr(first, all.find_last_not_of(blanks) - first + 1));
}

bool begins_as_text(std::string_view head) {
  if (head.find('\0') != std::string_view::npos) return false;
  std::istringstream stream{std::string(head)};
  StlWords words(stream);
  const std::string_view word = words.next();
  return is_word(word, "solid") || is_word(word, "facet");
}

}  // namespace clogflow
