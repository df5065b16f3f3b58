// Saved states beside the run file: the newest and the one before it.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
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

  /// The newest state that is whole, if there is one. `say` is told of each file passed over and why.
  std::optional<std::string> load(const std::function<void(const std::string&)>& say) const;

  /// The run is done: removes both.
  void remove();

private:
  std::filesystem::path newest_, older_;
  std::string identity_;
};

}  // namespace clog
