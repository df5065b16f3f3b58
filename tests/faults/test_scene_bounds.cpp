// Every key of the scene at its bounds, beyond them, and with the wrong kind of value: driven by the key
// table, so that a new key is tested the moment it exists.
#include <cmath>

#include <gmock/gmock.h>

#include "coupling/base/require.hpp"
#include "coupling/scene/scene.hpp"
#include "coupling/scene/scene_keys.hpp"
#include "tests/coupling/scene/scene_texts.hpp"

namespace clogflow::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// The message of the refusal, empty if the value is taken.
std::string answer(std::string_view path, const std::string& value) {
  try {
    const Scene scene = parse_scene(channel, "scene.toml", {fmt::format("{}={}", path, value)});
    // What is taken can be printed and read back as the same scene.
    EXPECT_EQ(effective_scene(parse_scene(effective_scene(scene), "again")), effective_scene(scene));
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

std::string written(double value, Dimension dimension) {
  return dimension == dimension::number ? fmt::format("{}", value) : format_quantity(value, dimension);
}

/// A refusal names the key it is about, or another one that it must agree with, on one line.
void expect_clear(const Key& key, const std::string& value, const std::string& message) {
  if (message.empty()) return;
  const std::string leaf(key.path.substr(key.path.rfind('.') + 1));
  EXPECT_THAT(message, Not(HasSubstr("\n"))) << key.path << " = " << value;
  // A value that another default follows from may be refused under the name of that one.
  if (message.find("by default (") == std::string::npos && !key.path.starts_with("box.")) {
    EXPECT_THAT(message, HasSubstr(leaf)) << value;
  }
  EXPECT_THAT(message, HasSubstr("(")) << "no reason: " << message;
  EXPECT_LT(message.size(), 400u) << message;
}

void expect_refused(const Key& key, const std::string& value) {
  const std::string message = answer(key.path, value);
  EXPECT_FALSE(message.empty()) << key.path << " = " << value << " was taken";
  expect_clear(key, value, message);
}

/// Taken or refused by another rule, but never by the range of the key itself.
void expect_in_range(const Key& key, const std::string& value, const Range& range) {
  const std::string message = answer(key.path, value);
  EXPECT_THAT(message, Not(HasSubstr(range.words()))) << key.path << " = " << value;
  expect_clear(key, value, message);
}

void at_one_bound(const Key& key, Dimension dimension, const Range& range, double bound, double outward) {
  const bool allowed = outward < 0 ? range.low_allowed : range.high_allowed;
  const double beyond = std::nextafter(bound, outward * 1e300), within = std::nextafter(bound, -outward * 1e300);
  if (allowed)
    expect_in_range(key, written(bound, dimension), range);
  else
    expect_refused(key, written(bound, dimension));
  expect_refused(key, written(beyond, dimension));
  expect_in_range(key, written(within, dimension), range);
}

struct TryOut {
  const Key& key;

  void range(Dimension dimension, const Range& range) const {
    if (std::isfinite(range.low)) at_one_bound(key, dimension, range, range.low, -1);
    if (std::isfinite(range.high)) at_one_bound(key, dimension, range, range.high, 1);
    for (const double extreme : {1e-300, 1e-30, 1e30, 1e300, -1e300}) {
      const std::string value = written(extreme, dimension);
      if (range.contains(extreme))
        expect_in_range(key, value, range);
      else
        expect_refused(key, value);
    }
    for (const char* never : {"nan", "inf", "-inf", "1e999", "[]", "{}", "true", "\"\"", "1979-05-27", "m", "1 m m m"})
      expect_refused(key, never);
  }

  void operator()(const NumberSlot& slot) const { range(slot.dimension, slot.range); }
  void operator()(const AngleSlot&) const {
    for (const char* bad : {"0 deg", "-1 deg", "90.0001 deg", "1e300 deg", "nan deg", "60", "60 m", "[]"})
      expect_refused(key, bad);
    for (const char* good : {"90 deg", "1 deg", "60 deg"}) expect_clear(key, good, answer(key.path, good));
  }
  void operator()(const VectorSlot& slot) const {
    for (const char* bad : {"[]", "[1, 2]", "[\"1 kg\", \"1 kg\", \"1 kg\"]", "true", "nan", "[1, 2, 3]"})
      expect_refused(key, bad);
    const std::string huge = fmt::format("\"1e300 {0}\"", si_unit(slot.dimension));
    const std::string value = fmt::format("[{0}, {0}, {0}]", huge);
    expect_clear(key, value, answer(key.path, value));
  }
  void operator()(const CountSlot& slot) const {
    for (const char* bad : {"1.5", "\"3\"", "true", "9223372036854775807", "9223372036854775808", "-1", "nan"})
      expect_refused(key, bad);
    for (const double bound : {slot.range.low, slot.range.high})
      expect_in_range(key, fmt::format("{}", static_cast<int>(bound)), slot.range);
    expect_refused(key, fmt::format("{}", static_cast<int>(slot.range.high) + 1));
  }
  void operator()(const SwitchSlot&) const {
    for (const char* bad : {"1", "\"true\"", "[]", "maybe"}) expect_refused(key, bad);
    for (const char* good : {"true", "false"}) expect_clear(key, good, answer(key.path, good));
  }
  void operator()(const TextSlot&) const {
    for (const char* bad : {"1", "true", "[]"}) expect_refused(key, bad);
    expect_clear(key, "text", answer(key.path, "\"no such \\n thing\""));
  }
  void operator()(const TextsSlot&) const {
    for (const char* bad :
         {"1", "true", "\"text\"", "[1]", "[\"no such key = 1\"]", "[\"time.end\"]", "[\"time.end=\"]"})
      expect_refused(key, bad);
    for (const char* good : {"[]", "[\"time.mass_scale = 1, 2\"]"}) EXPECT_EQ(answer(key.path, good), "") << good;
  }
  void operator()(const WordSlot& slot) const {
    for (const char* bad : {"1", "\"\"", "\"no such word\"", "true", "[]"}) expect_refused(key, bad);
    for (const std::string_view word : slot.words)
      expect_clear(key, std::string(word), answer(key.path, std::string(word)));
  }
  void operator()(const SpeciesSlot&) const {
    for (const char* bad : {"1", "\"\"", "[]", "[1]", "[{}]", "[{diameter=\"1 um\"}]", "[{diameter=1,share=1}]",
                            "[{diameter=\"1 s\",share=1.0}]", "[{diameter=\"1 um\",share=2.0}]",
                            "[{diameter=\"1 um\",share=nan}]", "[{diameter=\"0 um\",share=1.0}]", "true"})
      expect_refused(key, bad);
    EXPECT_EQ(answer(key.path, "[{diameter=\"33 um\",share=1.0,density=\"1 kg/m3\"}]"), "");
  }
  void operator()(const SeedsSlot&) const {
    for (const char* bad :
         {"\"\"", "\"a\"", "\"1-\"", "\"-1\"", "-1", "\"5-1\"", "\"1,,2\"", "1.5", "\"1-99999999999\"",
          "\"18446744073709551616\"", "\"0-18446744073709551615\"", "[1, 1.5]", "true"})
      expect_refused(key, bad);
    for (const char* good : {"1", "\"999999999\"", "\"1-40\"", "[3, 1]"}) EXPECT_EQ(answer(key.path, good), "") << good;
  }
};

class SceneBounds : public testing::TestWithParam<std::size_t> {};

TEST_P(SceneBounds, OfOneKey) {
  const Key& key = scene_keys()[GetParam()];
  std::visit(TryOut{key}, key.slot);
}

INSTANTIATE_TEST_SUITE_P(Keys, SceneBounds, testing::Range(std::size_t{0}, scene_keys().size()), [](const auto& info) {
  std::string name(scene_keys()[info.param].path);
  std::ranges::replace(name, '.', '_');
  return name;
});

}  // namespace
}  // namespace clogflow::test
