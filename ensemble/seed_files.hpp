// What a directory holds of the seeds of an ensemble, and whether it belongs to this scene.
#pragma once

#include <optional>

#include "dem/run/checkpoint.hpp"
#include "ensemble/seed_run.hpp"

namespace clogflow {

/// directory/run_0007.h5
std::filesystem::path run_file(const Ensemble& ensemble, std::uint64_t seed);

/// directory/ahead_0007.h5
std::filesystem::path ahead_file(const Ensemble& ensemble, std::uint64_t seed);

/// directory/shorter_0007.h5: a finished run that is being lengthened.
std::filesystem::path shorter_file(const Ensemble& ensemble, std::uint64_t seed);

/// The scene as the file of one seed carries it: its own seed alone, so that a file does not depend
/// on which other seeds were asked for.
Scene scene_of(const Scene& scene, std::uint64_t seed);

/// Whose the states of a seed are. \param inputs  inputs_hash of the ensemble
StateOwner owner_of(const Ensemble& ensemble, const std::string& inputs, std::uint64_t seed);

/// What is done of a seed, under whichever name.
struct Done {
  std::filesystem::path file;
  bool shorter;      ///< than time.end asks for
  std::string note;  ///< in what it differs from what is asked for without harm, or nothing
};

/// Nothing if nothing is done. \throws Error if what is there is another scene's, or a longer run
std::optional<Done> find_done(const Ensemble& ensemble, const StateOwner& owner);

/// Gives a shorter run its other name, so that all run files of a directory are equally long. The
/// caller holds the seed's lock. \throws Error unless it can be lengthened
void set_aside(const Ensemble& ensemble, const StateOwner& owner, const Done& shorter);

/// Gives what is done under another name its place: as run file, or ahead of the decision. The
/// caller holds the seed's lock.
void give_place(const Ensemble& ensemble, std::uint64_t seed, const std::filesystem::path& done);

/// Gives the file ahead its place as run file, if there is one. The caller holds the seed's lock.
/// \throws Error if it belongs to another scene
void accept_ahead(const Ensemble& ensemble, std::uint64_t seed);

/// Saved states tell a seed that goes on; one that does not must have none. The caller holds the
/// seed's lock.
void remove_states(const Ensemble& ensemble, std::uint64_t seed);

/// \throws Error if a file in the ensemble's directory was made for another scene, or another
/// time.end
void check_same_scene(const RunData& done, const Ensemble& ensemble, std::uint64_t seed,
                      const std::filesystem::path& file);

/// The seeds of a directory are of one scene.
/// \return a line on runs of another length that are not asked for, or nothing
/// \throws Error if runs or states of another scene are there
std::string check_directory(const Ensemble& ensemble, const std::string& inputs);

}  // namespace clogflow
