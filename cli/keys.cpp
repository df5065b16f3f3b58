// clog keys: the reference of all scene keys, for people, editors, man and the shell.
#include <memory>

#include <fmt/format.h>

#include "cli/output.hpp"
#include "cli/reference/verb_reference.hpp"
#include "cli/verbs.hpp"
#include "coupling/keys/key_prints.hpp"

namespace clogflow::cli {
namespace {

struct KeysOptions {
  std::string name, shell;
  bool json = false, page = false, schema = false, man = false;
};

void print_keys(const KeysOptions& options, const CLI::App& app) {
  if (options.schema) return print_result("{}\n", scene_schema().dump(2));
  if (options.man) return print_result("{}", man_page(app));
  if (!options.shell.empty()) return print_result("{}", shell_completion(app, options.shell));
  const std::vector<KeyEntry> entries = entries_of(options.name);
  if (options.json) return print_result("{}\n", keys_as_json(entries).dump(2));
  print_result("{}", options.page ? keys_as_page(entries) : keys_as_text(entries));
}

}  // namespace

void add_keys(CLI::App& app) {
  auto* verb = app.add_subcommand("keys", "every key of a scene: meaning, unit, allowed values, default");
  auto options = std::make_shared<KeysOptions>();
  auto* name =
      verb->add_option("name", options->name, "one key (particles.diameter) or section (contact); default: all");
  auto* form = verb->add_option_group("form", "as something else than text");
  form->add_flag("--json", options->json, "as JSON");
  form->add_flag("--page", options->page, "as the page docs/keys.md");
  form->add_flag("--schema", options->schema, "a JSON schema of scenes, for editors")->excludes(name);
  form->add_flag("--man", options->man, "the manual page clogflow.1")->excludes(name);
  form->add_option("--completion", options->shell, "completion for this shell: bash or zsh")
      ->check(CLI::IsMember({"bash", "zsh"}))
      ->excludes(name);
  form->require_option(0, 1);
  verb->callback([options, &app] { print_keys(*options, app); });
}

}  // namespace clogflow::cli
