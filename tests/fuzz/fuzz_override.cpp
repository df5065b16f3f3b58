// --set key=value on a scene that is otherwise good.
#include "coupling/scene.hpp"
#include "tests/coupling/scene_texts.hpp"
#include "tests/fuzz/one_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return clog::fuzz::try_input([&] { clog::parse_scene(clog::channel, "scene.toml", {clog::fuzz::as_text(data, size)}); });
}
