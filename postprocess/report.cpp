// Checks the tools first, then runs the scripts.
#include "coupling/source_folder.hpp"
#include "postprocess/report.hpp"

#include <cstdlib>
#include <sstream>

#include "coupling/require.hpp"
#include "postprocess/child_process.hpp"

namespace clog::postprocess {
namespace {

namespace fs = std::filesystem;

std::string environment(const char* variable, const std::string& otherwise) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0' ? value : otherwise;
}

std::string last_line(const std::string& text) {
  std::istringstream in(text);
  std::string last = "no output";
  for (std::string line; std::getline(in, line);) {
    if (!line.empty()) last = line;
  }
  return last;
}

void require_modules(const std::string& python) {
  const ChildResult check = run_program({python, "-c", "import numpy, h5py, matplotlib"});
  require(check.status == 0,
          "{}: {} (figures need it): apt-get install python3-matplotlib python3-h5py, or set "
          "CLOG_PYTHON to an "
          "interpreter that has them",
          python, last_line(check.output));
}

/// Runs a script of the figures. \return the files that it says it wrote
std::vector<fs::path> run_script(const std::string& name, const fs::path& from, const fs::path& out) {
  const std::string python = environment("CLOG_PYTHON", "/usr/bin/python3");
  const fs::path scripts = environment("CLOG_FIGURES", (source_folder() / "postprocess/figures").string());
  const fs::path script = scripts / name;
  require(fs::exists(script),
          "{}: not found (set CLOG_FIGURES to the folder of the figure scripts)", script.string());
  require_modules(python);
  const ChildResult made = run_program({python, "-B", script.string(), from.string(), out.string()});
  require(made.status == 0, "{} failed: {}", script.string(), last_line(made.output));
  std::vector<fs::path> files;
  std::istringstream in(made.output);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("wrote ")) files.emplace_back(line.substr(6));
  }
  return files;
}

}  // namespace

std::vector<fs::path> make_report(const fs::path& statistics, const fs::path& out) {
  return run_script("make_report.py", statistics, out);
}

std::vector<fs::path> make_trade_figure(const fs::path& results, const fs::path& out) {
  return run_script("fig_trade.py", results, out);
}

}  // namespace clog::postprocess
