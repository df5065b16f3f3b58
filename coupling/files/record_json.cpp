#include "coupling/files/record_json.hpp"

#include <functional>
#include <type_traits>

#include <nlohmann/json.hpp>

#include "coupling/base/json_text.hpp"
#include "coupling/base/require.hpp"

namespace clogflow {
namespace {

using nlohmann::json;

constexpr const char* place = "/provenance/record";

template <class T>
concept HasEntries = requires {
  T::entries();
};

template <class T>
constexpr bool is_optional = false;
template <class T>
constexpr bool is_optional<std::optional<T>> = true;

template <class T>
constexpr bool is_list = false;
template <class T>
constexpr bool is_list<std::vector<T>> = true;

template <class T>
json as_json(const T& value) {
  if constexpr (HasEntries<T>) {
    json object;
    for_each_entry<T>([&](const auto& entry) {
      const auto& member = value.*entry.member;
      if constexpr (!is_optional<std::remove_cvref_t<decltype(member)>>)
        object[entry.name] = as_json(member);
      else if (member)
        object[entry.name] = as_json(*member);
    });
    return object;
  } else if constexpr (is_list<T>) {
    json list = json::array();
    for (const auto& each : value) list.push_back(as_json(each));
    return list;
  } else {
    return value;
  }
}

template <class Record>
json with_others(const Record& record) {
  json object = as_json(record);
  for (const auto& [name, text] : record.others) object[name] = json::parse(text);
  return object;
}

/// Throws Error with the message unless the condition holds.
using Check = std::function<void(bool, const std::string&)>;

template <class T>
constexpr const char* kind() {
  if constexpr (HasEntries<T>) return "JSON object";
  if constexpr (is_list<T>) return "list";
  if constexpr (std::is_same_v<T, std::string>) return "text";
  if constexpr (std::is_same_v<T, bool>) return "true or false";
  if constexpr (std::is_integral_v<T>) return "whole number";
  return "number";
}

template <class T>
bool is_kind(const json& value) {
  if constexpr (HasEntries<T>) return value.is_object();
  if constexpr (is_list<T>) return value.is_array();
  if constexpr (std::is_same_v<T, std::string>) return value.is_string();
  if constexpr (std::is_same_v<T, bool>) return value.is_boolean();
  if constexpr (std::is_integral_v<T>) return value.is_number_integer();
  return value.is_number();
}

template <class T>
T from_json(const json& value, const std::string& name, const Check& check) {
  check(is_kind<T>(value), fmt::format("{} is no {}", name, kind<T>()));
  if constexpr (HasEntries<T>) {
    T record;
    for_each_entry<T>([&](const auto& entry) {
      auto& member = record.*entry.member;
      using Member = std::remove_reference_t<decltype(member)>;
      const auto found = value.find(entry.name);
      const std::string full = fmt::format("{}: {}", name, entry.name);
      if constexpr (!is_optional<Member>) {
        check(found != value.end(), full + " is missing");
        member = from_json<Member>(*found, full, check);
      } else if (found != value.end()) {
        member = from_json<typename Member::value_type>(*found, full, check);
      }
    });
    return record;
  } else if constexpr (is_list<T>) {
    T list;
    for (const json& each : value) list.push_back(from_json<typename T::value_type>(each, name, check));
    return list;
  } else {
    return value.get<T>();
  }
}

template <class Record>
Record record_of(const std::string& text, const Check& check) {
  const json object = parse_json(text);
  check(!object.is_discarded(), fmt::format("{} is no JSON, or nested too deep", place));
  if (object.is_null()) return {};
  Record record = from_json<Record>(object, place, check);
  for (const auto& [name, value] : object.items()) record.others[name] = value.dump();
  for_each_entry<Record>([&](const auto& entry) { record.others.erase(entry.name); });
  return record;
}

}  // namespace

json record_json(const RunRecord& record) { return with_others(record); }
json record_json(const FlowRecord& record) { return with_others(record); }

std::string record_text(const RunRecord& record) { return record_json(record).dump(); }

RunRecord run_record_of(const std::string& text) {
  return record_of<RunRecord>(
      text, [](bool good, const std::string& message) { require(good, "a saved state is damaged ({})", message); });
}

void write_record(Hdf5Writer& file, const RunRecord& record) { file.write_text(place, record_json(record).dump(2)); }
void write_record(Hdf5Writer& file, const FlowRecord& record) { file.write_text(place, record_json(record).dump(2)); }

template <class Record>
Record read_record(const Hdf5Reader& file) {
  return record_of<Record>(file.read_text(place),
                           [&](bool good, const std::string& message) { file.check(good, message); });
}

template RunRecord read_record(const Hdf5Reader&);
template FlowRecord read_record(const Hdf5Reader&);

}  // namespace clogflow
