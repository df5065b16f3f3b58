// The scene reader: what is taken prints and reads back as the same scene.
#include "coupling/scene.hpp"
#include "tests/fuzz/one_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return clog::fuzz::try_input([&] {
    const clog::Scene scene = clog::parse_scene(clog::fuzz::as_text(data, size), "scene.toml");
    const std::string printed = clog::effective_scene(scene);
    clog::fuzz::must(clog::effective_scene(clog::parse_scene(printed, "again")) == printed, "a printed scene reads back the same");
  });
}
