// The tables by which records go to files and come back: each entry has a name there, a unit, and a member here.
#pragma once

#include <tuple>
#include <type_traits>

namespace clogflow {

template <class Record, class Member>
struct RecordEntry {
  const char* name;        ///< in the file
  const char* unit;        ///< SI; "1" for numbers, empty for texts and parts
  Member Record::*member;  ///< std::optional where a file may lack it
};

template <class Record, class Member>
RecordEntry(const char*, const char*, Member Record::*) -> RecordEntry<Record, Member>;

/// Record::entries() is its table, a tuple of RecordEntry.
template <class Record, class Visit>
void for_each_entry(const Visit& visit) {
  std::apply([&](const auto&... entry) { (visit(entry), ...); }, Record::entries());
}

/// What a file calls a member.
template <class Record, class Member>
const char* entry_name(Member Record::*member) {
  const char* name = "";
  for_each_entry<Record>([&](const auto& entry) {
    if constexpr (std::is_same_v<decltype(entry.member), Member Record::*>)
      if (entry.member == member) name = entry.name;
  });
  return name;
}

}  // namespace clogflow
