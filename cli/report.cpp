// clog report: figures and one HTML page.
#include <filesystem>
#include <memory>

#include "cli/output.hpp"
#include "cli/verbs.hpp"
#include "postprocess/output/report.hpp"
#include "postprocess/output/statistics_files.hpp"

namespace clogflow::cli {
namespace {

struct ReportOptions {
  std::filesystem::path folder, out;
};

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
  auto* verb = app.add_subcommand("report", "figures (PNG, SVG) and one self-contained HTML page");
  auto options = std::make_shared<ReportOptions>();
  verb->add_option("dir", options->folder, "folder with stats.json, or with run files")->required();
  verb->add_option("--out", options->out, "folder for the report (default: DIR/report)");
  verb->callback([options] {
    if (options->out.empty()) options->out = options->folder / "report";
    for (const auto& file : postprocess::make_report(statistics_for(*options), options->out)) {
      print_result("{}\n", file.string());
    }
  });
}

}  // namespace clogflow::cli
