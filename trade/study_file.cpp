#include "trade/study_file.hpp"

#include <algorithm>
#include <array>

#include "coupling/base/json_text.hpp"
#include "coupling/base/require.hpp"
#include "coupling/base/text_file.hpp"

namespace clogflow::trade {
namespace {

using nlohmann::json;

bool has_number(const json& object, const char* key) { return object.contains(key) && object[key].is_number(); }
bool has_text(const json& object, const char* key) { return object.contains(key) && object[key].is_string(); }

bool is_setting(const json& setting) {
  if (!setting.is_object() || !has_text(setting, "name")) return false;
  if (!setting.contains("error")) return true;  // it was not run, or cannot be judged
  return has_text(setting, "kind") && setting.contains("overrides") &&
         std::ranges::all_of(std::array{"gain", "error", "hidden", "step_over_limit"},
                             [&](const char* key) { return has_number(setting, key); });
}

bool is_study(const json& study) {
  return study.is_object() && has_text(study, "format") && study["format"] == "clogflow trade 1" &&
         has_number(study, "diameter") && has_text(study, "reference") && study.contains("settings") &&
         study["settings"].is_array() && std::ranges::all_of(study["settings"], is_setting);
}

}  // namespace

json read_study(const std::filesystem::path& file) {
  json study = parse_json(read_text_file(file));
  require(is_study(study), "{}: not a trade.json of clog trade, or damaged", file.string());
  return study;
}

}  // namespace clogflow::trade
