// Saved states beside the run file: the newest and the one before it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "coupling/base/require.hpp"

namespace clogflow {

/// A state that is whole, but of a run that must not go on as ours. It is no damage: nothing may
/// take its place.
class StateRefused : public Error {
public:
  using Error::Error;
};

/// What a state belongs to.
struct StateOwner {
  std::string scene_text;       ///< effective scene
  std::string inputs;           ///< hash of what the scene only names: the flow, the files of particles and walls
  std::string build;            ///< of the program, which decides the layout of the bytes
  std::string instruction_set;  ///< which decides the last bits
  std::uint64_t seed = 0;

  template <class Archive>
  void exchange(Archive& archive) {
    archive(scene_text, inputs, build, instruction_set, seed);
  }
};

/// \throws StateRefused unless a run of `ours` goes on from what `theirs` left with the bits of one
/// in one go
void check_may_go_on(const StateOwner& theirs, const StateOwner& ours);

struct OwnedState {
  StateOwner owner;
  std::string state;
};

/// The bytes of a state with a version, what it belongs to, and a checksum; and back.
std::string pack_state(OwnedState owned);
/// \throws Error if the content is damaged; StateRefused if it is of another version
OwnedState unpack_state(const std::string& content);

/// Two files, so that a torn or damaged newest one costs one interval and not the run.
class Checkpoint {
public:
  /// \param run_file  run_0007.h5; the states are run_0007.state and run_0007.state.old
  Checkpoint(const std::filesystem::path& run_file, StateOwner owner);

  /// Puts the state in place of the newest, which becomes the older one. \throws Error
  void save(const std::string& state);

  /// Offers `take` the newest state that is whole, then the older one, until it does not throw.
  /// `say` is told of each file passed over and why. \return the file that was taken, or nothing
  /// \throws StateRefused, with the file's name, if one that is whole must not be used
  std::filesystem::path load(const std::function<void(const std::string&)>& take,
                             const std::function<void(const std::string&)>& say);

  /// Whether either is there.
  bool is_there() const;

  /// The run is done: removes both and what a killed process left of them, as far as the system
  /// lets it.
  void remove();

private:
  std::filesystem::path newest_, older_;
  StateOwner owner_;
  bool newest_is_good_ = false;  // only then may it take the place of the older one
};

}  // namespace clogflow
