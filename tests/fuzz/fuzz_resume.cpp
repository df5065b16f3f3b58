// A forged state, its checksum right: it is refused, or the run goes on with it, to its end or to a line.
#include "tests/fuzz/one_input.hpp"
#include "tests/fuzz/resumed_channel.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr int looks = 2;  // 256 steps
  return clog::fuzz::try_input([&] {
    clog::Simulation& run = *clog::fuzz::new_run();
    run.resume(clog::fuzz::as_text(data, size));
    int looked = 0;
    const clog::RunData done = run.run([&](const clog::Progress&) {
      clog::require(++looked < looks, "long enough");
    });
    clog::fuzz::must(clog::fault(done).empty(), "a run that ends can be written");
  });
}
