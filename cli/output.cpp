#include "cli/output.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <unistd.h>

#include <nlohmann/json.hpp>

#include "cli/log_file.hpp"
#include "coupling/base/require.hpp"

namespace clogflow::cli {
namespace {

constexpr const char *red = "\033[1;31m", *yellow = "\033[33m", *plain = "\033[0m", *wiped = "\r\033[K";
constexpr std::chrono::minutes renewed_in_log{1};

/// Of the process, as its streams are.
struct Output {
  std::string name = "clog";
  OutputOptions options;
  LogFile log;
  bool has_line = false;  // that can be wiped
  std::chrono::steady_clock::time_point last_in_log{};
};

Output& output() {
  static Output the;
  return the;
}

void put(std::FILE* stream, const std::string& text) {
  std::fputs(text.c_str(), stream);
  std::fflush(stream);
}

bool is_screen(std::FILE* stream) {
  const char* kind = std::getenv("TERM");
  return isatty(fileno(stream)) != 0 && !(kind && std::strcmp(kind, "dumb") == 0);
}

/// https://no-color.org: set and not empty is no.
bool has_colours(std::FILE* stream) {
  const char* no = std::getenv("NO_COLOR");
  return !(no && *no) && is_screen(stream);
}

/// "FIRST: text", FIRST in the colour where the stream has colours.
void put_line(std::FILE* stream, const char* colour, const std::string& first, const std::string& text) {
  wipe();
  const bool coloured = *colour && has_colours(stream);
  put(stream, fmt::format("{}{}:{} {}\n", coloured ? colour : "", first, coloured ? plain : "", text));
  output().log.add(fmt::format("{}: {}\n", first, text));
}

}  // namespace

void set_program_name(const std::string& path) {
  output().name = std::filesystem::path(path).filename() == "clogflow" ? "clogflow" : "clog";
}

const std::string& program_name() { return output().name; }

void begin_output(const OutputOptions& options, const std::string& call) {
  output().options = options;
  if (!options.log.empty()) output().log.open(options.log, call);
}

bool json_wanted() { return output().options.json; }

void print(Words words, const std::string& text) {
  const OutputOptions& options = output().options;
  const bool shown = words == Words::data || (!options.json && (words == Words::result || !options.quiet));
  if (shown) put(stdout, text);
  output().log.add(text);
}

void print_json(const nlohmann::json& object) { print(Words::data, object.dump(2) + "\n"); }

void print_note(const std::string& text) {
  if (output().options.quiet) return output().log.add(fmt::format("{}: {}\n", program_name(), text));
  put_line(stderr, "", program_name(), text);
}

void print_error(const std::string& text) { put_line(stderr, red, program_name(), text); }

void print_warning(const std::string& text) {
  if (json_wanted()) return output().log.add(fmt::format("warning: {}\n", text));
  put_line(stdout, yellow, "warning", text);
}

bool can_renew() { return is_screen(stderr) && !output().options.quiet; }

void renew(const std::string& line) {
  put(stderr, wiped + line);
  output().has_line = true;
  const auto now = std::chrono::steady_clock::now();
  if (now - output().last_in_log < renewed_in_log) return;
  output().last_in_log = now;
  output().log.add(line + "\n");
}

void wipe() {
  if (output().has_line) put(stderr, wiped);
  output().has_line = false;
}

void end_output() {
  require(std::fflush(stdout) == 0 && !std::ferror(stdout),
          "standard output cannot be written (disk full?): what was said is lost, files are not");
  require(output().log.is_whole(), "--log {}: cannot be written (disk full?): what was said is lost, files are not",
          output().options.log.string());
}

}  // namespace clogflow::cli
