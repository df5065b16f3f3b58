#include "coupling/base/json_text.hpp"

#include <stdexcept>

namespace clogflow {
namespace {

constexpr int deepest = 100;

struct TooDeep : std::runtime_error {
  TooDeep() : std::runtime_error("JSON nested too deep") {}
};

bool bounded(int depth, nlohmann::json::parse_event_t, nlohmann::json&) {
  if (depth > deepest) throw TooDeep();
  return true;
}

}  // namespace

nlohmann::json parse_json(const std::string& text) {
  try {
    return nlohmann::json::parse(text, bounded, false);
  } catch (const TooDeep&) {
    return nlohmann::json(nlohmann::json::value_t::discarded);
  }
}

}  // namespace clogflow
