// clogflow.1 in the man macros of troff.
#include <fmt/format.h>

#include "cli/reference/verb_reference.hpp"
#include "coupling/keys/key_reference.hpp"

namespace clogflow::cli {
namespace {

// Nothing in the text may be taken for a command: a backslash, or a dot or quote at the start of a line.
std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '\\')
      safe += "\\e";
    else if (c == '-')
      safe += "\\-";
    else if (c == '\n')
      safe += ' ';
    else
      safe += c;
  }
  return safe.starts_with('.') || safe.starts_with('\'') ? "\\&" + safe : safe;
}

std::string bold(const std::string& text) { return "\\fB" + escaped(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + escaped(text) + "\\fR"; }

std::string entry(const std::string& head, const std::string& body) { return ".TP\n" + head + "\n" + body + "\n"; }

// "--out FILE", or the name of what stands alone.
std::string option_head(const CLI::Option& option) {
  if (option.get_positional()) return italic(option.get_name());
  std::string head = bold(option.get_name(false, true));
  if (option.get_expected_max() > 0) head += " " + italic("VALUE");
  return head;
}

std::string verb_section(const CLI::App& verb) {
  std::string text = fmt::format(".SS {}\n{}.\n", bold("clogflow " + verb.get_name()), escaped(verb.get_description()));
  for (const CLI::Option* option : verb.get_options()) {
    if (option == verb.get_help_ptr()) continue;
    std::string body = escaped(option->get_description());
    if (option->get_required()) body += body.empty() ? "needed" : " (needed)";
    text += entry(option_head(*option), body.empty() ? "\\&" : body);
  }
  return text;
}

std::string key_sections() {
  std::string text;
  const std::string* section = nullptr;
  const std::vector<KeyEntry> entries = entries_of("");
  for (const KeyEntry& key : entries) {
    if (section == nullptr || *section != key.section)
      text += fmt::format(
          ".SS {}\n{}.\n",
          key.section.empty() ? "Scene keys before the first section" : "Scene keys of [" + escaped(key.section) + "]",
          escaped(std::string(section_meaning(key.section))));
    section = &key.section;
    const std::string allowed = key.allowed();
    text += entry(bold(key.name), escaped(fmt::format("{} ({}{}{}{}; {})", key.meaning, key.kind,
                                                      key.unit.empty() ? "" : " [" + key.unit + "]",
                                                      allowed.empty() ? "" : ", ", allowed, key.fallback_words())));
  }
  return text;
}

}  // namespace

std::vector<const CLI::App*> verbs_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

std::string man_page(const CLI::App& app) {
  std::string page = fmt::format(".TH CLOGFLOW 1 \"\" \"clogflow {}\" \"User commands\"\n", CLOG_VERSION);
  page += ".SH NAME\nclogflow \\- clogging of suspensions, from the flow field to the statistics\n";
  page += ".SH SYNOPSIS\n" + bold("clogflow") + " " + italic("VERB") + " [" + italic("OPTION") + "...]\n";
  page +=
      ".SH DESCRIPTION\nA scene is a text file (TOML) that describes geometry, fluid, particles and laws, every "
      "quantity with its unit. Each verb takes one step from the scene to the statistics and writes files that a "
      "person can open. In its build folder the program is called clog.\n";
  page += ".SH VERBS\n";
  for (const CLI::App* verb : verbs_of(app)) page += verb_section(*verb);
  page += ".SH SCENE KEYS\nWritten in a scene, or given as " + bold("--set") + " " + italic("KEY=VALUE") +
          ". Bounds are in the SI unit in brackets.\n" + key_sections();
  page += ".SH EXIT STATUS\n" + entry("0", "done") + entry("1", "refused or failed, with one line on standard error") +
          entry("2", "wrong usage") +
          entry("130, 143", "a run was stopped by Ctrl\\-C or SIGTERM; its states are saved, the same call goes on");
  page +=
      ".SH EXAMPLES\n.EX\nclogflow plan scenes/paper.toml\nclogflow case scenes/paper.toml my_flow && "
      "my_flow/Allrun && clogflow map my_flow \\-\\-out flow.h5\nclogflow run scenes/paper.toml \\-\\-flow flow.h5 "
      "\\-\\-seeds 1\\-8 \\-\\-out runs/first\nclogflow stats runs/first \\-\\-out runs/first/stats\n"
      "clogflow report runs/first/stats \\-\\-out runs/first/report\n.EE\n";
  return page;
}

}  // namespace clogflow::cli
