// clog film: the snapshots of a run as MP4 or WebM, or as PNG frames.
#include <filesystem>
#include <memory>
#include <string>

#include "cli/output.hpp"
#include "cli/verbs.hpp"
#include "coupling/base/require.hpp"
#include "coupling/base/units.hpp"
#include "postprocess/output/film.hpp"

namespace clogflow::cli {
namespace {

struct FilmOptions {
  postprocess::FilmJob job;
  std::string from, to;
};

void read_time(const char* option, const std::string& text, double& time) {
  if (text.empty()) return;
  time = parse_option(option, text, dimension::time, "a time, such as '120 ms'");
}

}  // namespace

void add_film(CLI::App& app) {
  auto* verb = app.add_subcommand("film", "the snapshots of a run as MP4 or WebM (ffmpeg), or as PNG frames");
  auto options = std::make_shared<FilmOptions>();
  verb->add_option("run", options->job.run, "run_NNNN.h5")->required();
  verb->add_option("--from", options->from, "simulated time of the first frame, '120 ms' (default: the start)");
  verb->add_option("--to", options->to, "of the last (default: the end)");
  verb->add_option("--out", options->job.out, "FILE.mp4, FILE.webm, or a folder for the frames")->required();
  verb->add_option("--every", options->job.every, "one frame for so many snapshots")->capture_default_str();
  verb->add_option("--rate", options->job.rate, "frames a second")->capture_default_str();
  verb->callback([options] {
    read_time("--from", options->from, options->job.from);
    read_time("--to", options->to, options->job.to);
    for (const auto& file : postprocess::make_film(options->job)) print_result("{}\n", file.string());
  });
}

}  // namespace clogflow::cli
