// A forged state, its checksum right: it is refused, or the run goes on with it, or ends with a line.
#include "tests/fuzz/one_input.hpp"
#include "tests/fuzz/resumed_channel.hpp"

// The flow is made once, outside the time of the first input.
extern "C" int LLVMFuzzerInitialize(int*, char***) {
  clog::fuzz::new_run();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr int steps = 8;
  return clog::fuzz::try_input([&] {
    clog::Simulation& run = *clog::fuzz::new_run();
    run.resume(clog::fuzz::as_text(data, size));
    for (int k = 0; k < steps; ++k) {
      run.compute_forces();
      run.record();
      run.advance();
    }
    clog::fuzz::must(clog::fault(run.data()).empty(), "what was recorded can be written");
  });
}
