// Variables of the environment.
#pragma once

#include <optional>
#include <string>

namespace clogflow {

/// What a variable is set to; nothing where it is not set.
std::optional<std::string> environment(const char* name);

/// The same as a whole number >= 0. \param why  what such a variable must hold, and what to do: "(...): ..."
/// \throws Error where it is set to anything else
std::optional<int> environment_number(const char* name, const char* why);

}  // namespace clogflow
