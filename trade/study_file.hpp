// trade.json and measured.json: what studies found, as files. Keys: trade/README.md.
#pragma once

#include <filesystem>
#include <string>

#include "trade/results.hpp"

namespace clogflow::trade {

/// trade.json of a study.
std::string study_text(const StudyResults& results);

/// trade.json, read back for --combine. \throws Error naming the file, unless it holds what the program chooses from
MeasuredStudy read_study(const std::filesystem::path& file);

/// By observable: the response to the step in a trade.json. \throws Error naming the file, unless it has one and is of
/// this scene with other sizes of particles
std::map<std::string, KnownSlope> read_step_slopes(const std::filesystem::path& file, const Scene& scene);

/// measured.json of several studies together, by rising D/d.
std::string measured_text(std::vector<MeasuredStudy> studies);

/// \throws a JSON error unless the text is of measured_text()
std::vector<MeasuredStudy> parse_measured(const std::string& text);

}  // namespace clogflow::trade
