// Finds the names in a TOML text without reading it: dots outside of quotes and comments, between
// two separators.
#include "coupling/scene/scene_bounds.hpp"

#include <algorithm>
#include <string_view>

#include "coupling/base/require.hpp"

namespace clogflow {
namespace {

constexpr int most_dots = 8;  // our longest name has two

// The end of the quoted text that begins at `at`; the end of all where nothing closes it.
std::size_t end_of_quoted(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string three(3, quote);
  const bool long_form = text.substr(at, 3) == three;
  const std::string_view closing = long_form ? std::string_view(three) : std::string_view(three).substr(0, 1);
  for (at += closing.size(); at < text.size(); ++at) {
    if (text[at] == '\\' && quote == '"') {
      ++at;
    } else if (text.substr(at, closing.size()) == closing) {
      return at + closing.size();
    } else if (text[at] == '\n' && !long_form) {
      return at;
    }
  }
  return text.size();
}

}  // namespace

void check_scene_text(const std::string& text, const std::string& name) {
  require(text.size() <= longest_scene, "{} ({} bytes: a scene has at most {})", name, text.size(), longest_scene);
  int dots = 0;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == '"' || c == '\'') {
      at = end_of_quoted(text, at);
      continue;
    }
    if (c == '#') {
      at = std::min(text.find('\n', at), text.size());
      continue;
    }
    if (std::string_view("\n=,[]{}").find(c) != std::string_view::npos) dots = 0;
    if (c == '.') ++dots;
    if (dots > most_dots)
      throw Error(fmt::format("{}:{}: a name of more than {} parts (no key has so many)", name,
                              1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'),
                              most_dots + 1));
    ++at;
  }
}

}  // namespace clogflow
