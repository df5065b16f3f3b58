// What a scene's text may be, before the TOML library takes it.
#pragma once

#include <string>

namespace clogflow {

/// A million seeds one by one are more [byte]
inline constexpr std::size_t longest_scene = 1 << 22;

/// The library calls itself for every part of a dotted name, and has no bound of its own.
/// \throws Error("<name>:<line>: ...") for a text that is too long or has a name of too many parts
void check_scene_text(const std::string& text, const std::string& name);

}  // namespace clogflow
