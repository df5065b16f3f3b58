// One TOML value into one place of the scene, checked against its entry in the key table.
#pragma once

#include <string>

#include <toml++/toml.h>

#include "coupling/scene/scene_keys.hpp"

namespace clogflow {

/// The value as a person would write it, short and on one line.
std::string shown_value(const toml::node& value);

/// \throws Error "<prefix> = <value> (<what is allowed>)"
void set_value(const Key& key, const toml::node& value, Scene& scene);

}  // namespace clogflow
