// Figures and the HTML page: starts the python scripts of postprocess/figures.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace clogflow::postprocess {

/// How a report looks, and what its page tells beside the statistics.
struct ReportLook {
  double figure_width = 0;     ///< of every figure [m]; 0: as wide as its panels want to be
  double font_size = 0;        ///< [pt]; 0: 8.5
  std::filesystem::path flow;  ///< flow.h5 of the runs, whose error the page tells; empty: it does not
  std::string command;         ///< that makes it, for the page
};

inline constexpr double narrowest_figure = 0.06, widest_figure = 0.4;  ///< [m]
inline constexpr double smallest_font = 4, largest_font = 24;          ///< [pt]

/// Makes the figures (PNG, SVG, and PDF with its fonts) and report.html in `out` from statistics that already exist.
/// The interpreter is /usr/bin/python3, where Debian's matplotlib is, unless CLOG_PYTHON names
/// another; the scripts are those of the source tree unless CLOG_FIGURES names another folder.
/// Each file gets its name when it is whole, the page as the last.
/// \param statistics folder with stats.json and the tables
/// \return the files made
/// \throws Error when the look is out of its bounds; python, a module or a script is missing, or the scripts fail
/// (their last line)
std::vector<std::filesystem::path> make_report(const std::filesystem::path& statistics,
                                               const std::filesystem::path& out, const ReportLook& look = {});

/// Draws cost against error from a trade.json into a folder. \return the files \throws Error as above
std::vector<std::filesystem::path> make_trade_figure(const std::filesystem::path& results,
                                                     const std::filesystem::path& out);

}  // namespace clogflow::postprocess
