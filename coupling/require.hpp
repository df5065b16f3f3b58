// Errors that a user can cause: one exception type, one always-on check.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace clog {

/// A refusal with one clear line: *problem (why) what to do*. Only `main` catches it.
class Error : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// Throws Error with the formatted message unless the condition holds; never compiled out.
template <class... Args>
void require(bool condition, fmt::format_string<Args...> message, Args&&... args) {
  if (!condition) throw Error(fmt::format(message, std::forward<Args>(args)...));
}

}  // namespace clog
