// All that a verb says to a person or a program goes through here: what --quiet leaves out, what --json replaces, what
// --log keeps, and colours.
#pragma once

#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json_fwd.hpp>

namespace clogflow::cli {

/// The options that every verb has; `json` only those that say so.
struct OutputOptions {
  bool quiet = false;
  bool json = false;
  std::filesystem::path log;  ///< empty: none
};

/// How the program was called, "clog" or "clogflow": its lines on standard error begin with it.
void set_program_name(const std::string& path);
const std::string& program_name();

/// From now on. \param call  the words of the command line, for the log
/// \throws Error if the log cannot be opened, or the file is there and is no log
void begin_output(const OutputOptions& options, const std::string& call);

bool json_wanted();

enum class Words {
  narration,  ///< what may be left out
  result,     ///< what the verb was called for
  data        ///< for a program to read: the only thing on standard output with --json
};

/// To standard output, as it is, at once. What cannot be written, on a full disk for example, is lost, and main() says
/// so at the end; fmt::print would throw in the middle of a run.
void print(Words words, const std::string& text);

template <class... T>
void print_words(fmt::format_string<T...> text, T&&... values) {
  print(Words::narration, fmt::format(text, std::forward<T>(values)...));
}

template <class... T>
void print_result(fmt::format_string<T...> text, T&&... values) {
  print(Words::result, fmt::format(text, std::forward<T>(values)...));
}

template <class... T>
void print_data(fmt::format_string<T...> text, T&&... values) {
  print(Words::data, fmt::format(text, std::forward<T>(values)...));
}

void print_json(const nlohmann::json& object);

/// "clog: TEXT" on standard error; not with --quiet.
void print_note(const std::string& text);

/// Likewise, always, and red on a terminal.
void print_error(const std::string& text);

/// "warning: TEXT" among the results, yellow on a terminal.
void print_warning(const std::string& text);

/// Whether lines can be wiped and renewed: a terminal, and not a dumb one.
bool can_renew();

/// In the place of the last such line on standard error; the log has one a minute of them.
void renew(const std::string& line);
void wipe();

/// Standard output and the log are whole. \throws Error which is not
void end_output();

}  // namespace clogflow::cli
