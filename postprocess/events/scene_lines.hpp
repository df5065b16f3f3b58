// An effective scene as key and value text: what two runs have in common, and what a sweep varies.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace clogflow::postprocess {

/// "section.key" -> value as written; only for the text that effective_scene produces.
using SceneLines = std::map<std::string, std::string>;

/// Leaves out the sections `ensemble` and `output`: they do not change what happens in a run. Keys that an earlier
/// program did not print have the value of then.
SceneLines scene_lines(const std::string& effective_scene);

/// The text without the line of one key.
std::string without_key(const std::string& effective_scene, const std::string& key);

/// Keys that are not the same in both.
std::vector<std::string> differing_keys(const SceneLines& a, const SceneLines& b);

}  // namespace clogflow::postprocess
