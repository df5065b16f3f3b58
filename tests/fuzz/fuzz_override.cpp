// --set key=value on a scene that is otherwise good.
#include "coupling/scene/scene.hpp"
#include "tests/coupling/scene/scene_texts.hpp"
#include "tests/fuzz/one_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return clogflow::fuzz::try_input(
      [&] { clogflow::parse_scene(clogflow::channel, "scene.toml", {clogflow::fuzz::as_text(data, size)}); });
}
