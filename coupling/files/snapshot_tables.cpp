#include "coupling/files/snapshot_tables.hpp"

#include <algorithm>
#include <type_traits>

#include "coupling/base/require.hpp"

namespace clogflow {
namespace {

// The vectors of one snapshot; `width` numbers a particle.
template <class Snapshot, class Visit>
void for_each_quantity(Snapshot& snapshot, const Visit& visit) {
  visit("id", snapshot.id, "1", 1);
  visit("radius", snapshot.radius, "m", 1);
  visit("position", snapshot.position, "m", 3);
  visit("velocity", snapshot.velocity, "m/s", 3);
  visit("spin", snapshot.spin, "rad/s", 3);
  visit("force", snapshot.force, "N", 3);
  visit("torque", snapshot.torque, "N m", 3);
}

// The contacts of one snapshot; `width` numbers a contact.
template <class Contacts, class Visit>
void for_each_contact_column(Contacts& contacts, const Visit& visit) {
  visit("a", contacts.a, "1", 1);
  visit("b", contacts.b, "1", 1);
  visit("normal", contacts.normal, "1", 3);
  visit("force", contacts.force, "N", 3);
}

// Where each snapshot begins in the arrays of a group, and where the last one ends.
std::vector<std::size_t> read_bounds(const Hdf5Reader& in, const std::string& group, std::size_t snapshots,
                                     std::size_t rows) {
  const auto first = in.read<std::int64_t>(group + "/first", "1").values;
  in.check(first.size() == snapshots, group + " has arrays of different length");
  std::vector<std::size_t> bounds(first.begin(), first.end());
  bounds.push_back(rows);
  in.check(std::ranges::is_sorted(bounds) && bounds[0] == 0, group + "/first is impossible");
  return bounds;
}

// Rows from bounds[k] to bounds[k + 1], of `width` numbers each.
template <class Values>
Values rows_between(const Values& all, const std::vector<std::size_t>& bounds, std::size_t k, std::size_t width) {
  const auto at = [&](std::size_t row) { return all.begin() + static_cast<std::ptrdiff_t>(width * row); };
  return Values(at(bounds[k]), at(bounds[k + 1]));
}

/// Columns of one length, between particles of the snapshot or with a wall.
std::string fault_in_contacts(const RunData::Snapshot& snapshot) {
  const RunData::Contacts& contacts = snapshot.contacts;
  std::string wrong;
  for_each_contact_column(contacts, [&](const char* name, const auto& values, const char*, std::size_t width) {
    if (wrong.empty() && values.size() != width * contacts.a.size())
      wrong = fmt::format("/contacts/{} has {} numbers for {} contacts at {} s", name, values.size(), contacts.a.size(),
                          snapshot.time);
  });
  if (!wrong.empty() || contacts.a.empty()) return wrong;
  std::vector<std::int64_t> known = snapshot.id;
  std::ranges::sort(known);
  const auto is_unknown = [&](std::int64_t id) { return !std::ranges::binary_search(known, id); };
  for (std::size_t k = 0; k < contacts.a.size(); ++k)
    if (is_unknown(contacts.a[k]) || (contacts.b[k] != -1 && is_unknown(contacts.b[k])))
      return fmt::format("/contacts names the particles {} and {} at {} s, of which one is not there", contacts.a[k],
                         contacts.b[k], snapshot.time);
  return {};
}

}  // namespace

void write_snapshots(Hdf5Writer& out, const std::vector<RunData::Snapshot>& snapshots) {
  RunData::Snapshot all;
  std::vector<double> time;
  std::vector<std::int64_t> first;
  for (const RunData::Snapshot& snapshot : snapshots) {
    time.push_back(snapshot.time);
    first.push_back(static_cast<std::int64_t>(all.id.size()));
    const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    append(all.id, snapshot.id);
    append(all.radius, snapshot.radius);
    append(all.species, snapshot.species);
    append(all.position, snapshot.position);
    append(all.velocity, snapshot.velocity);
    append(all.spin, snapshot.spin);
    append(all.force, snapshot.force);
    append(all.torque, snapshot.torque);
  }
  out.write("/snapshots/time", time, {.unit = "s", .shape = {}});
  out.write("/snapshots/first", first, {.unit = "1", .shape = {}});
  for_each_quantity(all, [&](const std::string& name, const auto& values, const char* unit, std::size_t width) {
    const std::size_t count = all.id.size();
    out.write("/snapshots/" + name, values,
              {.unit = unit, .shape = width == 1 ? std::vector{count} : std::vector{count, width}});
  });
  if (!all.species.empty()) out.write("/snapshots/species", all.species, {.unit = "1", .shape = {}});
}

void write_contacts(Hdf5Writer& out, const std::vector<RunData::Snapshot>& snapshots) {
  RunData::Contacts all;
  std::vector<std::int64_t> first;
  for (const RunData::Snapshot& snapshot : snapshots) {
    first.push_back(static_cast<std::int64_t>(all.a.size()));
    const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    append(all.a, snapshot.contacts.a);
    append(all.b, snapshot.contacts.b);
    append(all.normal, snapshot.contacts.normal);
    append(all.force, snapshot.contacts.force);
  }
  out.write("/contacts/first", first, {.unit = "1", .shape = {}});
  for_each_contact_column(all, [&](const std::string& name, const auto& values, const char* unit, std::size_t width) {
    const std::size_t count = all.a.size();
    out.write("/contacts/" + name, values,
              {.unit = unit, .shape = width == 1 ? std::vector{count} : std::vector{count, width}});
  });
}

void read_contacts(const Hdf5Reader& in, std::vector<RunData::Snapshot>& snapshots) {
  RunData::Contacts all;
  for_each_contact_column(all, [&](const std::string& name, auto& values, const char* unit, std::size_t width) {
    using Value = typename std::remove_cvref_t<decltype(values)>::value_type;
    values = in.read<Value>("/contacts/" + name, unit).values;
    in.check(values.size() == width * all.a.size(), "/contacts has arrays of different length");
  });
  const std::vector<std::size_t> bounds = read_bounds(in, "/contacts", snapshots.size(), all.a.size());
  for (std::size_t k = 0; k < snapshots.size(); ++k)
    snapshots[k].contacts = {rows_between(all.a, bounds, k, 1), rows_between(all.b, bounds, k, 1),
                             rows_between(all.normal, bounds, k, 3), rows_between(all.force, bounds, k, 3)};
}

std::vector<RunData::Snapshot> read_snapshots(const Hdf5Reader& in) {
  const auto time = in.read<double>("/snapshots/time", "s").values;
  RunData::Snapshot all;
  for_each_quantity(all, [&](const std::string& name, auto& values, const char* unit, std::size_t width) {
    using Value = typename std::remove_cvref_t<decltype(values)>::value_type;
    values = in.read<Value>("/snapshots/" + name, unit).values;
    in.check(values.size() == width * all.id.size(), "/snapshots has arrays of different length");
  });
  if (in.has("/snapshots/species")) {
    all.species = in.read<std::int64_t>("/snapshots/species", "1").values;
    in.check(all.species.size() == all.id.size(), "/snapshots has arrays of different length");
  }
  const std::vector<std::size_t> bounds = read_bounds(in, "/snapshots", time.size(), all.id.size());
  std::vector<RunData::Snapshot> snapshots(time.size());
  for (std::size_t i = 0; i < snapshots.size(); ++i) {
    const auto slice = [&](const auto& from, std::size_t width) { return rows_between(from, bounds, i, width); };
    RunData::Snapshot& snapshot = snapshots[i];
    snapshot.time = time[i];
    snapshot.id = slice(all.id, 1);
    snapshot.radius = slice(all.radius, 1);
    if (!all.species.empty()) snapshot.species = slice(all.species, 1);
    snapshot.position = slice(all.position, 3);
    snapshot.velocity = slice(all.velocity, 3);
    snapshot.spin = slice(all.spin, 3);
    snapshot.force = slice(all.force, 3);
    snapshot.torque = slice(all.torque, 3);
  }
  return snapshots;
}

std::string fault_in_snapshots(const std::vector<RunData::Snapshot>& snapshots) {
  std::string wrong;
  for (const RunData::Snapshot& snapshot : snapshots)
    for_each_quantity(snapshot, [&](const char* name, const auto& values, const char*, std::size_t width) {
      if (wrong.empty() && values.size() != width * snapshot.id.size())
        wrong = fmt::format("/snapshots/{} has {} numbers for {} particles at {} s", name, values.size(),
                            snapshot.id.size(), snapshot.time);
    });
  for (const RunData::Snapshot& snapshot : snapshots)
    if (wrong.empty() && !snapshot.species.empty() && snapshot.species.size() != snapshot.id.size())
      wrong = fmt::format("/snapshots/species has {} numbers for {} particles at {} s", snapshot.species.size(),
                          snapshot.id.size(), snapshot.time);
  for (const RunData::Snapshot& snapshot : snapshots)
    if (wrong.empty()) wrong = fault_in_contacts(snapshot);
  return wrong;
}

}  // namespace clogflow
