// What a message quotes of a text from outside.
#pragma once

#include <string>
#include <string_view>

namespace clogflow {

inline constexpr std::size_t longest_shown = 120;

/// On one line and not longer than one: no control characters, and the end cut off where it is
/// longer.
std::string shown_text(std::string_view text, std::size_t longest = longest_shown);

}  // namespace clogflow
