#include "ensemble/short_runs.hpp"

#include <chrono>
#include <thread>

#include "ensemble/seed_files.hpp"
#include "ensemble/seed_lock.hpp"

namespace clogflow {

namespace {

/// To rename a file takes no longer.
constexpr int most_tries = 500;
constexpr std::chrono::milliseconds between_tries{10};

}  // namespace

void set_aside_if_short(const Ensemble& ensemble, const std::string& inputs, std::uint64_t seed) {
  try {
    const StateOwner owner = owner_of(ensemble, inputs, seed);
    const auto is_to_go = [&](const std::optional<Done>& done) {
      return done && done->shorter && done->file != shorter_file(ensemble, seed);
    };
    // Who else has the lock is doing the same.
    for (int tries = 0; is_to_go(find_done(ensemble, owner)) && tries < most_tries; ++tries) {
      const auto lock = SeedLock::take(run_file(ensemble, seed), "");
      if (!lock)
        std::this_thread::sleep_for(between_tries);
      else if (const auto done = find_done(ensemble, owner); is_to_go(done))
        set_aside(ensemble, owner, *done);
    }
  } catch (const std::exception&) {
    // Said when the seed's turn comes.
  }
}

}  // namespace clogflow
