// A run file cut down to what statistics keep, as bytes: files are read by several processes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "postprocess/events/scene_lines.hpp"
#include "postprocess/events/seed_record.hpp"

namespace clogflow::postprocess {

/// What is the same for all runs of a scene.
struct RunKind {
  std::string scene_text, record;  ///< effective scene and record of its first run
  SceneLines lines;

  template <class Archive>
  void exchange(Archive& archive) {
    archive(scene_text, record);
    if constexpr (Archive::loading) lines = scene_lines(scene_text);
  }
};

struct RunDigest {
  std::size_t kind = 0;     ///< number of its scene among those that its reader met
  bool kind_known = false;  ///< false: the file could not be read
  bool kind_is_new = false;
  RunKind new_kind;
  std::string error;  ///< what stands against its use, or empty
  std::int64_t necks = 1;
  SeedRecord record;
  std::vector<SeedRecord> of_necks;  ///< as each neck of several saw the run

  template <class Archive>
  void exchange(Archive& archive) {
    archive(kind, kind_known, kind_is_new, error, necks, record, of_necks);
    if (kind_is_new) archive(new_kind);
  }
};

/// Reads files one after another and knows the scenes that it met.
class DigestMaker {
public:
  /// \param threshold  T_min [s]; absent: tau/2
  explicit DigestMaker(std::optional<double> threshold) : threshold_(threshold) {}

  /// Never throws: what is wrong is in the digest.
  RunDigest digest_of(const std::filesystem::path& file);

private:
  struct Kind {
    SceneLines lines;
    Scene scene;
    ClogScale scale;
    std::string error;
  };

  void digest(const std::filesystem::path& file, RunDigest& digest);
  const Kind& kind_of(const RunData& run, const std::filesystem::path& file, RunDigest& digest);

  std::optional<double> threshold_;
  std::vector<Kind> kinds_;
};

}  // namespace clogflow::postprocess
