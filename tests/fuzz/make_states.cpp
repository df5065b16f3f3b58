// States of a run, from the beginning of the filling to the end, some of them with friction off; into the folder given.
#include "coupling/publish_file.hpp"
#include "tests/fuzz/resumed_channel.hpp"

int main(int, char** arguments) {
  const std::filesystem::path folder = arguments[1];
  clog::Simulation& run = *clog::fuzz::new_run();
  int looks = 0;
  run.run([&](const clog::Progress&) {
    if (looks++ % 12 == 0) clog::publish_file(run.save(), folder / "resume" / std::to_string(looks));
  });
}
