// A run as a film: its snapshots drawn one by one.
#pragma once

#include <filesystem>
#include <limits>
#include <vector>

namespace clogflow::postprocess {

/// What is filmed of a run, and where to.
struct FilmJob {
  std::filesystem::path run;
  std::filesystem::path out;  ///< FILE.mp4, FILE.webm, or a folder for the frames
  double from = -std::numeric_limits<double>::infinity(), to = -from;  ///< [s]
  int every = 1;                                                       ///< each snapshot, each second one, ...
  int rate = 20;                                                       ///< frames a second
};

inline constexpr std::size_t most_film_frames = 600;

/// The snapshots of a run as a film, or as PNG pictures. \return the files
/// \throws Error when python or a module is missing; there is no snapshot in that time or too many, ffmpeg is missing,
/// or the folder holds frames already
std::vector<std::filesystem::path> make_film(const FilmJob& job);

}  // namespace clogflow::postprocess
