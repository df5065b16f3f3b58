// clog report: figures and one HTML page.
#include <filesystem>
#include <memory>

#include "cli/output.hpp"
#include "cli/verbs.hpp"
#include "coupling/base/require.hpp"
#include "coupling/base/shown_text.hpp"
#include "coupling/base/units.hpp"
#include "coupling/files/hdf5_file.hpp"
#include "postprocess/output/report.hpp"
#include "postprocess/output/statistics_files.hpp"

namespace clogflow::cli {
namespace {

struct ReportOptions {
  std::filesystem::path folder, out;
  std::string width;
  postprocess::ReportLook look;
};

/// Of the words that were given, so that a shell gives them again.
std::string command_of(const ReportOptions& options) {
  const auto quoted = [](const std::string& word) {
    return word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._/-+=") ==
                   std::string::npos
               ? word
               : "'" + word + "'";
  };
  std::string text =
      fmt::format("clog report {} --out {}", quoted(options.folder.string()), quoted(options.out.string()));
  if (!options.look.flow.empty()) text += " --flow " + quoted(options.look.flow.string());
  if (!options.width.empty()) text += " --figure-width " + quoted(options.width);
  if (options.look.font_size > 0) text += fmt::format(" --font-size {}", options.look.font_size);
  return text;
}

void read_look(ReportOptions& options) {
  if (!options.width.empty()) {
    const double width = parse_option("--figure-width", options.width, dimension::length, "a length, such as '85 mm'");
    options.look.figure_width = width;
    require(width > 0, "--figure-width {}: from {} to {} mm", options.width, 1e3 * postprocess::narrowest_figure,
            1e3 * postprocess::widest_figure);
  }
  if (!options.look.flow.empty()) {
    const std::string format = file_format(options.look.flow).name;
    require(format == "clogflow flow", "--flow {}: a \"{}\" file (must be a flow.h5)", options.look.flow.string(),
            shown_text(format));
  }
  options.look.command = command_of(options);
}

/// The folder itself when `clog stats` wrote there; otherwise its run files are evaluated first.
std::filesystem::path statistics_for(const ReportOptions& options) {
  if (std::filesystem::exists(options.folder / "stats.json")) return options.folder;
  postprocess::StatisticsJob job;
  job.folders = {options.folder};
  job.out = options.out;
  postprocess::write_statistics(job);
  return options.out;
}

}  // namespace

void add_report(CLI::App& app) {
  auto* verb = app.add_subcommand("report", "figures (PNG, SVG, PDF) and one self-contained HTML page");
  auto options = std::make_shared<ReportOptions>();
  verb->add_option("dir", options->folder, "folder with stats.json, or with run files")->required();
  verb->add_option("--out", options->out, "folder for the report (default: DIR/report)");
  verb->add_option("--flow", options->look.flow, "flow.h5 of the runs: the page tells its error");
  verb->add_option("--figure-width", options->width, "of every figure, '85 mm' (default: as its panels need)");
  verb->add_option("--font-size", options->look.font_size, "in the figures, in points (default: 8.5)");
  verb->callback([options] {
    if (options->out.empty()) options->out = options->folder / "report";
    read_look(*options);
    for (const auto& file : postprocess::make_report(statistics_for(*options), options->out, options->look)) {
      print_result("{}\n", file.string());
    }
  });
}

}  // namespace clogflow::cli
