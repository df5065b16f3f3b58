// A pack: the run files of a finished ensemble in one file, each whole in a group of its name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "coupling/files/hdf5_file.hpp"

namespace clogflow {

inline const FileFormat pack_format{.name = "clogflow pack", .version = 1};

/// Appends run files one after another. Every member throws Error naming the file.
class RunPackWriter {
public:
  explicit RunPackWriter(const std::filesystem::path& pack) : out_(pack, pack_format) {}

  /// All that is in a run file, byte for byte, under its file name.
  void add(const std::filesystem::path& run_file);
  /// A text that lay beside the runs, such as ensemble.csv.
  void add_text(const std::string& name, const std::string& text) { out_.write_text("/" + name, text); }
  void finish() { out_.finish(); }

private:
  Hdf5Writer out_;
};

/// "pack.h5/run_0001.h5" ..., in order of name; readers take them as they take files in a folder (hdf5_file.hpp).
/// \throws Error if the file is no pack, is cut off, or holds no run
std::vector<std::filesystem::path> runs_in_pack(const std::filesystem::path& pack);

/// First object whose contents, type, extent or attributes differ between two run files, or an empty text.
/// \throws Error if one of them cannot be read
std::string run_difference(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace clogflow
