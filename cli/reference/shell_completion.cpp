// Rules for the shell. What does not depend on our verbs and keys is the text of two functions.
#include <fmt/format.h>

#include "cli/reference/verb_reference.hpp"
#include "coupling/keys/key_reference.hpp"

namespace clogflow::cli {
namespace {

std::string options_of(const CLI::App& verb) {
  std::string all;
  for (const CLI::Option* option : verb.get_options())
    for (const std::string& name : option->get_lnames()) all += (all.empty() ? "--" : " --") + name;
  return all;
}

// bash cuts words at "=", zsh does not: the functions put the word together again and offer what comes behind "=".
constexpr std::string_view functions = R"shell(
_clogflow_key()  # the key, or the words that it may be, for "KEY=VALUE" in $1
{
    if [[ $1 == *=* ]]; then
        local before=
        [[ -n ${ZSH_VERSION:-} ]] && before=${1%%=*}=
        COMPREPLY=($(compgen -P "$before" -W "$(_clogflow_words "${1%%=*}")" -- "${1#*=}"))
    else
        COMPREPLY=($(compgen -S = -W "$_clogflow_keys" -- "$1"))
        [[ -n ${ZSH_VERSION:-} ]] || compopt -o nospace
    fi
}

_clogflow()
{
    local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]}
    COMPREPLY=()
    if ((COMP_CWORD == 1)); then
        COMPREPLY=($(compgen -W "$_clogflow_verbs --help --version" -- "$word"))
        return
    fi
    # "--set", key, "=", value are four words in bash
    if [[ $word == "=" ]]; then
        word=$previous=
        previous=${COMP_WORDS[COMP_CWORD-2]}
    elif [[ $previous == "=" ]]; then
        word=${COMP_WORDS[COMP_CWORD-2]}=$word
        previous=${COMP_WORDS[COMP_CWORD-3]}
    fi
    if [[ $previous == --set || $previous == --sweep ]]; then
        _clogflow_key "$word"
    elif [[ ${COMP_WORDS[1]} == keys && $word != -* ]]; then
        COMPREPLY=($(compgen -W "$_clogflow_keys" -- "$word"))
    elif [[ $word == -* ]]; then
        COMPREPLY=($(compgen -W "$(_clogflow_options "${COMP_WORDS[1]}")" -- "$word"))
    else
        COMPREPLY=($(compgen -f -- "$word"))
        [[ -n ${ZSH_VERSION:-} ]] || compopt -o filenames
    fi
}
complete -F _clogflow clogflow clog
)shell";

}  // namespace

std::string shell_completion(const CLI::App& app, const std::string& shell) {
  std::string verbs, keys, options, words;
  for (const CLI::App* verb : verbs_of(app)) {
    verbs += (verbs.empty() ? "" : " ") + verb->get_name();
    options += fmt::format("        {}) echo \"{}\" ;;\n", verb->get_name(), options_of(*verb));
  }
  for (const KeyEntry& key : entries_of("")) {
    keys += (keys.empty() ? "" : " ") + key.name;
    std::string all = key.kind == "true or false" ? "true false" : "";
    for (const std::string& word : key.words) all += (all.empty() ? "" : " ") + word;
    if (!all.empty()) words += fmt::format("        {}) echo \"{}\" ;;\n", key.name, all);
  }
  std::string text = "# Completion of clogflow, made by `clogflow keys --completion " + shell + "`\n";
  if (shell == "zsh") text += "autoload -U +X compinit && compinit -u\nautoload -U +X bashcompinit && bashcompinit\n";
  text += fmt::format("_clogflow_verbs=\"{}\"\n_clogflow_keys=\"{}\"\n", verbs, keys);
  text += "_clogflow_options()\n{\n    case $1 in\n" + options + "    esac\n}\n";
  text += "_clogflow_words()\n{\n    case $1 in\n" + words + "    esac\n}\n";
  return text + std::string(functions);
}

}  // namespace clogflow::cli
