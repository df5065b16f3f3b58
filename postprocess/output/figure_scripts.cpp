// Checks the tools first, then runs the scripts, then publishes what they drew.
#include "postprocess/output/figure_scripts.hpp"

#include <cstdlib>
#include <cstring>
#include <sstream>

#include "coupling/base/child_process.hpp"
#include "coupling/base/file_part.hpp"
#include "coupling/base/publish_file.hpp"
#include "coupling/base/require.hpp"
#include "coupling/base/source_folder.hpp"
#include "coupling/base/text_file.hpp"

namespace clogflow::postprocess {
namespace {

namespace fs = std::filesystem;

std::string last_line(const std::string& text) {
  std::istringstream in(text);
  std::string last = "no output";
  for (std::string line; std::getline(in, line);) {
    if (!line.empty()) last = line;
  }
  return last;
}

constexpr int killed = 128;  // a larger status is this plus the signal that ended the program

std::string how_it_failed(const ChildResult& child) {
  const std::string said = last_line(child.output);
  if (child.status <= killed) return said;
  const int signal = child.status - killed;
  return fmt::format("ended by signal {}, {}; last line: {}", signal, strsignal(signal), said);
}

void require_modules(const std::string& python) {
  const ChildResult check = run_program({python, "-c", "import numpy, h5py, matplotlib, jinja2"});
  require(check.status <= killed, "{}: cannot load the modules of the figures ({})", python, how_it_failed(check));
  require(check.status == 0,
          "{}: {} (figures need it): apt-get install python3-matplotlib python3-h5py python3-jinja2, or set "
          "CLOG_PYTHON to an "
          "interpreter that has them",
          python, last_line(check.output));
}

/// Where scripts write before anything has its name: a folder inside `out` that belongs to whoever
/// holds the lock of the part it is named after. That lock is held by a script too that outlives
/// its caller.
class DrawingFolder {
public:
  explicit DrawingFolder(const fs::path& out) : part_(made(out) / ".drawing"), path_(part_.path().string() + ".d") {
    std::error_code failure;
    fs::remove_all(path_, failure);
    if (!failure) fs::create_directory(path_, failure);
    require(!failure, "{}: cannot be made ({})", path_.string(), failure.message());
  }
  ~DrawingFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  DrawingFolder(const DrawingFolder&) = delete;
  DrawingFolder& operator=(const DrawingFolder&) = delete;

  const fs::path& path() const { return path_; }
  int lock() const { return part_.descriptor(); }

private:
  static fs::path made(const fs::path& out) {
    std::error_code failure;
    fs::create_directories(out, failure);
    require(!failure, "{}: cannot be made ({})", out.string(), failure.message());
    return out;
  }

  FilePart part_;
  fs::path path_;
};

}  // namespace

std::string of_environment(const char* variable, const std::string& otherwise) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0' ? value : otherwise;
}

std::vector<fs::path> run_figure_script(const std::string& name, fs::path from, const fs::path& out,
                                        const std::string& job, const std::vector<std::string>& more) {
  const std::string python = of_environment("CLOG_PYTHON", "/usr/bin/python3");
  const fs::path scripts = of_environment("CLOG_FIGURES", (source_folder() / "postprocess/figures").string());
  const fs::path script = scripts / name;
  require(fs::exists(script), "{}: not found (set CLOG_FIGURES to the folder of the figure scripts)", script.string());
  require_modules(python);
  const DrawingFolder drawn(out);
  if (!job.empty()) publish_file(job, from = drawn.path() / "job.json");
  std::vector<std::string> words{python, "-B", script.string(), from.string(), drawn.path().string()};
  words.insert(words.end(), more.begin(), more.end());
  const ChildResult made = run_program(words, drawn.lock());
  require(made.status == 0, "{}: no figures ({} failed: {})", out.string(), script.string(), how_it_failed(made));
  std::vector<fs::path> files;
  std::istringstream in(made.output);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("wrote ")) continue;
    const fs::path file = line.substr(6);
    files.push_back(out / file.filename());
    publish_file(read_text_file(file), files.back());
  }
  return files;
}

}  // namespace clogflow::postprocess
