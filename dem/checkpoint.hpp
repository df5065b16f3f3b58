// Saved states beside the run file: the newest and the one before it.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace clog {

/// Two files, so that a torn or damaged newest one costs one interval and not the run. Each carries a
/// version, what it belongs to, and a checksum.
class Checkpoint {
public:
  /// \param run_file  run_0007.h5; the states are run_0007.state and run_0007.state.old
  /// \param identity  what must be the same for a state to be usable: scene, seed, flow
  Checkpoint(const std::filesystem::path& run_file, std::string identity);

  /// Puts the state in place of the newest, which becomes the older one. \throws Error
  void save(const std::string& state);

  /// Offers `take` the newest state that is whole, then the older one, until it does not throw. `say` is
  /// told of each file passed over and why.
  /// \return whether one was taken
  bool load(const std::function<void(const std::string&)>& take,
            const std::function<void(const std::string&)>& say);

  /// The run is done: removes both and what a killed process left of them, as far as the system lets it.
  void remove();

private:
  std::filesystem::path newest_, older_;
  std::string identity_;
  bool newest_is_good_ = false;  // only then may it take the place of the older one
};

}  // namespace clog
