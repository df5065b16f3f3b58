// Figures and the HTML page: starts the python scripts of postprocess/figures.
#pragma once

#include <filesystem>
#include <vector>

namespace clogflow::postprocess {

/// Makes the figures (PNG and SVG) and report.html in `out` from statistics that already exist.
/// The interpreter is /usr/bin/python3, where Debian's matplotlib is, unless CLOG_PYTHON names
/// another; the scripts are those of the source tree unless CLOG_FIGURES names another folder.
/// Each file gets its name when it is whole, the page as the last.
/// \param statistics folder with stats.json and the tables
/// \return the files made
/// \throws Error when python, a module or a script is missing, or the scripts fail (their last
/// line)
std::vector<std::filesystem::path> make_report(const std::filesystem::path& statistics,
                                               const std::filesystem::path& out);

/// Draws cost against error from a trade.json into a folder. \return the files \throws Error as above
std::vector<std::filesystem::path> make_trade_figure(const std::filesystem::path& results,
                                                     const std::filesystem::path& out);

}  // namespace clogflow::postprocess
