// Scenes and values that were made to exhaust the reader: refused at once, in a line that quotes
// little of them.
#include <sys/stat.h>

#include <chrono>

#include <gmock/gmock.h>

#include "coupling/base/shown_text.hpp"
#include "coupling/base/units.hpp"
#include "coupling/scene/scene_bounds.hpp"
#include "coupling/scene/sweep.hpp"
#include "tests/coupling/flow_scene.hpp"
#include "tests/coupling/refusal.hpp"

namespace clogflow {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

std::string repeated(const std::string& part, int times) {
  std::string text;
  for (int k = 0; k < times; ++k) text += part;
  return text;
}

constexpr int deep = 40'000;
constexpr const char* too_deep = "a name of more than 9 parts";

TEST(HostileScene, NamesOfManyParts) {
  const std::string name = repeated("a.", deep) + "a";
  for (const std::string& text : {name + " = 1", "[" + name + "]", "[[" + name + "]]",
                                  repeated("\"a\" . ", deep) + "a = 1", "x = {y = [{" + name + " = 1}]}"})
    EXPECT_THAT(refusal([&] { parse_scene("\n" + text + "\n", "deep.toml"); }),
                AllOf(StartsWith("deep.toml:2: "), HasSubstr(too_deep)))
        << text.substr(0, 20);
  EXPECT_THAT(refusal([&] { flow_scene({"particles.diameter={" + name + "=1}"}); }),
              AllOf(StartsWith("--set "), HasSubstr(too_deep)));
}

TEST(HostileScene, DotsElsewhereAreNoParts) {
  const std::string dots = repeated(".", 30);
  EXPECT_NO_THROW(check_scene_text("# " + dots + "\na = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 1.5]\n", "x"));
  EXPECT_NO_THROW(check_scene_text("a = \"" + dots + "\"\nb = '" + dots + "'\nc = \"\\\"" + dots + "\"\n", "x"));
  EXPECT_NO_THROW(check_scene_text("a = \"\"\"\n" + dots + "\"\n" + dots + "\"\"\"\nb = '''" + dots + "'''\n", "x"));
  EXPECT_THAT(refusal([&] { check_scene_text("a = \"\"\"\"\"\"\n" + dots, "x"); }), StartsWith("x:2: "));
}

TEST(HostileScene, ValuesNestedDeep) {
  EXPECT_THAT(refusal([&] { parse_scene("a = " + repeated("[", deep), "nested.toml"); }),
              StartsWith("nested.toml:1: "));
  EXPECT_THAT(refusal([&] { parse_scene("a = " + repeated("{a=", deep), "nested.toml"); }),
              StartsWith("nested.toml:1: "));
}

/// Seconds that a refusal takes; a slow machine needs some hundredths.
template <class Action>
double seconds_of(const Action& action) {
  const auto before = std::chrono::steady_clock::now();
  action();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
}

TEST(HostileScene, AKeyOfMegabytes) {
  const ScratchFolder scratch;
  const auto file = scratch.path() / "long.toml";
  const auto try_length = [&](std::size_t length) {
    write_file(file, std::string(length, 'k') + " = 1\n");
    std::string message;
    EXPECT_LT(seconds_of([&] { message = refusal([&] { read_scene(file); }); }), 10);
    EXPECT_LT(message.size(), 500u);
    return message;
  };
  EXPECT_THAT(try_length(20'000'000), HasSubstr("20000005 bytes: a scene has at most 4194304"));
  EXPECT_THAT(try_length(4'000'000), HasSubstr("kkk... = 1 (unknown key"));
  EXPECT_THAT(refusal([] { flow_scene({std::string(100'000, 'k') + "=1"}); }), HasSubstr("unknown key"));
}

/// 100,000 characters in the place of every kind of value.
TEST(HostileScene, MessagesQuoteALine) {
  const std::string endless(100'000, 'v');
  for (const std::string& text :
       {"particles.diameter=" + endless, "particles.diameter=1 " + endless,
        "particles.diameter=" + std::string(100'000, '1'), "contact.friction.sliding=" + endless,
        "flow.source=" + endless, "ensemble.seeds=" + endless, "inlet.enabled=" + endless,
        "flow.velocity=[" + endless + "]", endless, "particles=" + endless,
        "ensemble.seeds=[" + repeated("1.5,", 30'000) + "]"}) {
    const std::string message = refusal([&] { flow_scene({text}); });
    EXPECT_LT(message.size(), 2 * longest_shown + 400) << text.substr(0, 40);
  }
  const ScratchFolder scratch;
  write_file(scratch.path() / "scene.toml", "");
  EXPECT_LT(refusal([&] { read_scene(scratch.path() / "scene.toml", {"geometry.stl=" + endless}); }).size(), 800u);
  EXPECT_LT(refusal([&] { parse_quantity(endless); }).size(), 250u);
  EXPECT_LT(refusal([&] { sweep_points({"particles.diameter=" + endless + "," + endless}); }).size(), 400u);
  EXPECT_LT(refusal([&] { parse_scene("a = 1\na = 2 " + endless, "x"); }).size(), 400u);
}

TEST(HostileScene, WallsInAPipeDoNotWait) {
  const ScratchFolder scratch;
  const std::string pipe = scratch.path() / "walls.stl";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  Scene scene = flow_scene();
  scene.geometry.stl = pipe;
  EXPECT_THAT(refusal([&] { flow_inputs(scene); }), HasSubstr("walls.stl\" (there is no such file)"));
}

TEST(HostileScene, NoMessageIsEndless) {
  const std::string message = Error("begins " + std::string(1'000'000, 'x') + " ends").what();
  EXPECT_LT(message.size(), 1010u);
  EXPECT_THAT(message, AllOf(StartsWith("begins x"), testing::EndsWith("x ends")));
}

TEST(ShownText, CutsBetweenCharactersAndStaysOnOneLine) {
  EXPECT_EQ(shown_text("short"), "short");
  EXPECT_EQ(shown_text("a\nb\x1b[31m"), "a b [31m");
  EXPECT_EQ(shown_text("abcdef", 4), "abcd...");
  EXPECT_EQ(shown_text("abc\u00b5m", 4), "abc...");
  EXPECT_EQ(shown_text("abc\u00b5m", 5), "abc\u00b5...");
  EXPECT_EQ(shown_text("\x80\x80\x80\x80\x80", 4).size(), 4u);
}

}  // namespace
}  // namespace clogflow
