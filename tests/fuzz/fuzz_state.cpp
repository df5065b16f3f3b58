// A saved state behind its checksum: the archive of the recorded data and of the random generator.
#include "coupling/archive.hpp"
#include "coupling/run_file.hpp"
#include "dem/particles.hpp"
#include "dem/random.hpp"
#include "tests/fuzz/one_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return clog::fuzz::try_input([&] {
    clog::ArchiveReader archive(clog::fuzz::as_text(data, size));
    clog::RunData run;
    clog::Random random(1);
    clog::Particles particles;
    bool gate_closed = false;
    archive(gate_closed, random, particles, run);
    clog::require(archive.at_end(), "a saved state is longer than it should be");
  });
}
