// The scene reader: what is taken prints and reads back as the same scene.
#include "coupling/scene/scene.hpp"
#include "tests/fuzz/one_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return clogflow::fuzz::try_input([&] {
    const clogflow::Scene scene = clogflow::parse_scene(clogflow::fuzz::as_text(data, size), "scene.toml");
    const std::string printed = clogflow::effective_scene(scene);
    clogflow::fuzz::must(clogflow::effective_scene(clogflow::parse_scene(printed, "again")) == printed,
                         "a printed scene reads back the same");
  });
}
