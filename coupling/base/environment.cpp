#include "coupling/base/environment.hpp"

#include <charconv>
#include <cstdlib>

#include "coupling/base/require.hpp"

namespace clogflow {

std::optional<std::string> environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? std::optional<std::string>(value) : std::nullopt;
}

std::optional<int> environment_number(const char* name, const char* why) {
  const auto text = environment(name);
  if (!text) return {};
  int value = -1;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value);
  require(error == std::errc() && end == text->data() + text->size() && value >= 0, "{} = {} {}", name, *text, why);
  return value;
}

}  // namespace clogflow
