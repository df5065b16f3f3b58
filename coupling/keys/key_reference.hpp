// A scene key in words: what `clog keys`, its page, the JSON schema, the man page and the shell's completion say of it.
// All of it follows from the key table of coupling/scene/scene_keys.cpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "coupling/scene/scene_keys.hpp"

namespace clogflow {

struct KeyEntry {
  std::string name;                ///< "contact.friction.sliding"
  std::string section;             ///< "contact"; empty before the first section
  std::string kind;                ///< "length", "number", "word", "true or false", ...
  std::string unit;                ///< of SI, in which bounds are given; empty for what has none
  std::vector<std::string> words;  ///< all that are allowed, where the value is a word
  std::string bounds;              ///< "> 0", "in [0, 1)"; empty: any
  std::string fallback;            ///< the default in words; "none"; "required" and when
  std::string meaning;             ///< in one sentence, without the default
  std::string example;             ///< as it is written in a scene

  /// Words or bounds or nothing: `"nearest" or "trilinear"`.
  std::string allowed() const;
  bool required() const { return fallback.starts_with("required"); }
  /// "default: 48", "required with flow.pulsation.strength"
  std::string fallback_words() const { return (required() ? "" : "default: ") + fallback; }
};

KeyEntry describe(const Key& key);

/// What a section is about, in a few words; for the keys before the first section too (empty name).
std::string_view section_meaning(std::string_view section);

/// All of them for an empty name; one key; or those of a section ("contact", "contact.friction").
/// \throws Error naming what is close to an unknown name
std::vector<KeyEntry> entries_of(std::string_view name);

}  // namespace clogflow
