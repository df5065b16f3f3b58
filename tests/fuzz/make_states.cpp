// States of a run, from the beginning of the filling to the end, some of them with friction off; into the folder given.
#include "coupling/base/publish_file.hpp"
#include "tests/fuzz/resumed_channel.hpp"

int main(int, char** arguments) {
  const std::filesystem::path folder = arguments[1];
  clogflow::Simulation& run = *clogflow::fuzz::new_run();
  int looks = 0;
  run.run([&](const clogflow::Progress&) {
    if (looks++ % 12 == 0) clogflow::publish_file(run.save(), folder / "resume" / std::to_string(looks));
  });
}
