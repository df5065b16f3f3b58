// Errors that a user can cause: one exception type, one always-on check.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace clogflow {

/// A refusal with one clear line: *problem (why) what to do*. Only `main` catches it.
class Error : public std::runtime_error {
public:
  explicit Error(std::string message) : std::runtime_error(one_line(std::move(message))) {}

private:
  /// A message quotes what the user gave: a line break or a control character in that stays one line, and what is
  /// endless loses its middle, since the remedy comes last.
  static std::string one_line(std::string text) {
    constexpr std::size_t longest = 1000, head = 600;
    if (text.size() > longest) text.replace(head, text.size() - longest, " ... ");
    for (char& c : text)
      if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
    return text;
  }
};

/// Throws Error with the formatted message unless the condition holds; never compiled out.
template <class... Args>
void require(bool condition, fmt::format_string<Args...> message, Args&&... args) {
  if (!condition) throw Error(fmt::format(message, std::forward<Args>(args)...));
}

}  // namespace clogflow
