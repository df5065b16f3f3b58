// A forged state, its checksum right: it is refused, or the run goes on with it, or ends with a line.
#include "tests/fuzz/one_input.hpp"
#include "tests/fuzz/resumed_channel.hpp"

// The flow is made once, outside the time of the first input.
extern "C" int LLVMFuzzerInitialize(int*, char***) {
  clogflow::fuzz::new_run();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr int steps = 8;
  return clogflow::fuzz::try_input([&] {
    clogflow::Simulation& run = *clogflow::fuzz::new_run();
    run.resume(clogflow::fuzz::as_text(data, size));
    for (int k = 0; k < steps; ++k) {
      run.compute_forces();
      run.record();
      run.advance();
    }
    clogflow::fuzz::must(clogflow::fault(run.data()).empty(), "what was recorded can be written");
  });
}
