// One table of columns serves writer and reader, so they cannot disagree about names and units.
#include "coupling/files/run_file.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "coupling/base/require.hpp"
#include "coupling/files/hdf5_file.hpp"
#include "coupling/files/record_json.hpp"
#include "coupling/files/snapshot_index.hpp"
#include "coupling/files/snapshot_tables.hpp"

namespace clogflow {
namespace {

const FileFormat run_format{.name = "clogflow run", .version = 1};

// Run: RunData or const RunData. Visit: called with group, column, values, unit.
template <class Run, class Visit>
void for_each_column(Run& run, const Visit& visit) {
  visit("/passages", "time", run.passages.time, "s");
  visit("/passages", "id", run.passages.id, "1");
  visit("/passages", "y", run.passages.y, "m");
  visit("/passages", "z", run.passages.z, "m");
  visit("/passages", "friction_off", run.passages.friction_off, "1");
  visit("/releases", "off", run.releases.off, "s");
  visit("/releases", "on", run.releases.on, "s");
  visit("/releases", "largest_speed", run.releases.largest_speed, "m/s");
  visit("/releases", "position", run.releases.position, "m");
  visit("/series", "time", run.series.time, "s");
  visit("/series", "count", run.series.count, "1");
  visit("/series", "packing_fraction", run.series.packing_fraction, "1");
  visit("/series", "kinetic_energy", run.series.kinetic_energy, "J");
  visit("/series", "elastic_energy", run.series.elastic_energy, "J");
  visit("/series", "largest_overlap", run.series.largest_overlap, "m");
  visit("/series", "contacts", run.series.contacts, "1");
  visit("/series", "wall_contacts", run.series.wall_contacts, "1");
  visit("/series", "drag_work", run.series.drag_work, "J");
  visit("/series", "dissipated", run.series.dissipated, "J");
  visit("/series", "median_speed", run.series.median_speed, "m/s");
  visit("/series", "speed_q99", run.series.speed_q99, "m/s");
}

// Whether a column tells of events or of the filling, which is all that statistics need.
bool is_of_events(std::string_view group, std::string_view column) {
  return group != "/series" || column == "time" || column == "count" || column == "packing_fraction";
}

// Of a flow that is not steady; left out of the file where they are empty.
template <class Run, class Visit>
void for_each_drive_column(Run& run, const Visit& visit) {
  visit("flow_factor", run.series.flow_factor, "1");
  visit("pressure_drop", run.series.pressure_drop, "Pa");
}

// Columns of passages that only runs of unequal particles have.
template <class Run, class Visit>
void for_each_size(Run& run, const Visit& visit) {
  visit("/passages/radius", run.passages.radius, "m");
  visit("/passages/species", run.passages.species, "1");
}

bool is_ordered(const std::vector<double>& times) {
  return std::ranges::is_sorted(times) && std::ranges::all_of(times, [](double t) { return std::isfinite(t); });
}

}  // namespace

RunRows rows_of(const RunData& run) {
  return {run.passages.time.size(), run.releases.off.size(), run.series.time.size(), run.snapshots.size()};
}

bool cut_rows(RunData& run, const RunRows& rows) {
  const RunRows there = rows_of(run);
  if (rows.passages > there.passages || rows.releases > there.releases || rows.series > there.series ||
      rows.snapshots > there.snapshots || !fault(run).empty())
    return false;
  for_each_column(run, [&](std::string_view group, const char*, auto& values, const char*) {
    values.resize(group == "/passages" ? rows.passages : group == "/releases" ? rows.releases : rows.series);
  });
  run.passages.neck.clear();
  for_each_size(run, [&](const char*, auto& values, const char*) {
    if (!values.empty()) values.resize(rows.passages);
  });
  run.series.porosity.resize(rows.series);
  for_each_drive_column(run, [&](const char*, std::vector<double>& values, const char*) {
    if (!values.empty()) values.resize(rows.series);
  });
  run.snapshots.resize(rows.snapshots);
  return true;
}

namespace {

enum class Part { all, events };

std::string fault_in(const RunData& run, Part part) {
  std::string wrong;
  std::string_view table;
  std::size_t rows = 0;
  for_each_column(run, [&](std::string_view group, const char* column, const auto& values, const char*) {
    if (part == Part::events && !is_of_events(group, column)) return;
    if (group != table) rows = values.size();
    table = group;
    if (wrong.empty() && values.size() != rows)
      wrong = fmt::format("{}/{} has {} rows (the columns before it have {})", group, column, values.size(), rows);
  });
  for_each_drive_column(run, [&](const char* column, const std::vector<double>& values, const char*) {
    if (wrong.empty() && !values.empty() && values.size() != run.series.time.size())
      wrong = fmt::format("/series/{} has {} rows (the other columns have {})", column, values.size(),
                          run.series.time.size());
  });
  for_each_size(run, [&](const char* column, const auto& values, const char*) {
    if (wrong.empty() && !values.empty() && values.size() != run.passages.time.size())
      wrong = fmt::format("{} has {} rows (the columns before it have {})", column, values.size(),
                          run.passages.time.size());
  });
  if (wrong.empty() && run.passages.radius.size() != run.passages.species.size())
    wrong = "/passages has a radius or a species of its particles without the other";
  if (!wrong.empty()) return wrong;
  const auto& neck = run.passages.neck;
  if (!neck.empty() && neck.size() != run.passages.time.size())
    return fmt::format("/passages/neck has {} rows (the columns before it have {})", neck.size(),
                       run.passages.time.size());
  const std::int64_t necks = run.record.necks.value_or(1);
  if (!std::ranges::all_of(neck, [&](std::int64_t k) { return k >= 0 && k < necks; }))
    return fmt::format("/passages/neck names a neck beyond the {} of the record", necks);
  if (run.series.porosity.size() != run.series.time.size())
    return fmt::format("/series/porosity has {} rows (the other columns have {})", run.series.porosity.size(),
                       run.series.time.size());
  for (const auto& row : run.series.porosity)
    if (row.size() != run.series.porosity[0].size()) return "/series/porosity has rows of different length";
  wrong = fault_in_snapshots(run.snapshots);
  if (!wrong.empty()) return wrong;
  if (!is_ordered(run.passages.time)) return "/passages/time is not in ascending order, or not finite";
  if (!is_ordered(run.series.time)) return "/series/time is not in ascending order, or not finite";
  if (!(std::isfinite(run.end_time) && run.end_time >= 0))
    return fmt::format("/end_time is {} s (must be from 0 on)", run.end_time);
  return {};
}

}  // namespace

std::string fault(const RunData& run) { return fault_in(run, Part::all); }

namespace {

void write_porosity(Hdf5Writer& out, const std::vector<std::vector<double>>& rows) {
  std::vector<double> values;
  for (const auto& row : rows) values.insert(values.end(), row.begin(), row.end());
  out.write("/series/porosity", values, {.unit = "1", .shape = {rows.size(), rows.empty() ? 0 : rows[0].size()}});
}

std::vector<std::vector<double>> read_porosity(const Hdf5Reader& in, std::size_t samples) {
  const Hdf5Array<double> array = in.read<double>("/series/porosity", "1");
  in.check(array.shape.size() == 2, "/series/porosity is not [samples][strips]");
  const std::size_t strips = array.shape[1];
  // Without strips no numbers are stored, so the number of rows is all that bounds what follows.
  in.check(array.shape[0] <= samples, "/series/porosity has more rows than /series/time");
  std::vector<std::vector<double>> rows(array.shape[0]);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto first = array.values.begin() + static_cast<std::ptrdiff_t>(i * strips);
    rows[i].assign(first, first + static_cast<std::ptrdiff_t>(strips));
  }
  return rows;
}

/// Present where the plane has several openings.
constexpr const char* neck_column = "/passages/neck";

void read_necks(const Hdf5Reader& in, RunData& run) {
  if (in.has(neck_column)) run.passages.neck = in.read<std::int64_t>(neck_column, "1").values;
}

}  // namespace

void write_run_file(const RunData& run, const std::filesystem::path& file) {
  const std::string wrong = fault(run);
  require(wrong.empty(), "{}: {}", file.string(), wrong);
  Hdf5Writer out(file, run_format);
  for_each_column(run, [&](const std::string& group, const char* column, const auto& values, const char* unit) {
    out.write(group + "/" + column, values, {.unit = unit, .shape = {}});
  });
  if (!run.passages.neck.empty()) out.write(neck_column, run.passages.neck, {.unit = "1", .shape = {}});
  for_each_size(run, [&](const char* column, const auto& values, const char* unit) {
    if (!values.empty()) out.write(column, values, {.unit = unit, .shape = {}});
  });
  write_porosity(out, run.series.porosity);
  for_each_drive_column(run, [&](const std::string& column, const std::vector<double>& values, const char* unit) {
    if (!values.empty()) out.write("/series/" + column, values, {.unit = unit, .shape = {}});
  });
  write_snapshots(out, run.snapshots);
  if (run.has_contacts) write_contacts(out, run.snapshots);
  out.write("/end_time", std::vector<double>{run.end_time}, {.unit = "s", .shape = {}});
  out.write("/provenance/seed", std::vector<std::uint64_t>{run.seed}, {.unit = "1", .shape = {}});
  out.write_text("/provenance/scene", run.scene_text);
  write_record(out, run.record);
  if (!run.end_state.empty())
    out.write("/end_state", std::vector<std::uint8_t>(run.end_state.begin(), run.end_state.end()),
              {.unit = "1", .shape = {}});
  // The run file comes last: where it stands, the seed is done.
  write_snapshot_index(run, file);
  out.finish();
}

namespace {

void read_head(const Hdf5Reader& in, RunData& run) {
  const auto end_time = in.read<double>("/end_time", "s").values;
  const auto seed = in.read<std::uint64_t>("/provenance/seed", "1").values;
  in.check(end_time.size() == 1 && seed.size() == 1, "/end_time or /provenance/seed is not one number");
  run.end_time = end_time[0];
  run.seed = seed[0];
  run.scene_text = in.read_text("/provenance/scene");
  run.record = read_record<RunRecord>(in);
}

RunData read_part(const std::filesystem::path& file, Part part) {
  const Hdf5Reader in(file, run_format);
  RunData run;
  for_each_column(run, [&](const std::string& group, const char* column, auto& values, const char* unit) {
    if (part == Part::events && !is_of_events(group, column)) return;
    using Value = typename std::remove_cvref_t<decltype(values)>::value_type;
    auto array = in.read<Value>(group + "/" + column, unit);
    in.check(array.shape.size() == 1, group + "/" + column + " is not a column");
    values = std::move(array.values);
  });
  read_necks(in, run);
  for_each_size(run, [&](const char* column, auto& values, const char* unit) {
    using Value = typename std::remove_cvref_t<decltype(values)>::value_type;
    if (in.has(column)) values = in.read<Value>(column, unit).values;
  });
  run.series.porosity = read_porosity(in, run.series.time.size());
  if (part == Part::all) {
    for_each_drive_column(run, [&](const std::string& column, std::vector<double>& values, const char* unit) {
      if (in.has("/series/" + column)) values = in.read<double>("/series/" + column, unit).values;
    });
    run.snapshots = read_snapshots(in);
    run.has_contacts = in.has("/contacts/first");
    if (run.has_contacts) read_contacts(in, run.snapshots);
  }
  read_head(in, run);
  const std::string wrong = fault_in(run, part);
  in.check(wrong.empty(), wrong);
  for (const auto* times : {&run.passages.time, &run.series.time, &run.releases.off})
    in.check(
        times->empty() || times->back() <= run.end_time,
        fmt::format("a time of {} s is beyond /end_time = {} s", times->empty() ? 0 : times->back(), run.end_time));
  return run;
}

}  // namespace

RunData read_run_file(const std::filesystem::path& file) { return read_part(file, Part::all); }

RunData read_run_events(const std::filesystem::path& file) { return read_part(file, Part::events); }

RunData read_run_head(const std::filesystem::path& file) {
  RunData run;
  read_head(Hdf5Reader(file, run_format), run);
  return run;
}

std::string read_end_state(const std::filesystem::path& file) {
  const Hdf5Reader in(file, run_format);
  if (!in.has("/end_state")) return {};
  const auto bytes = in.read<std::uint8_t>("/end_state", "1").values;
  return {bytes.begin(), bytes.end()};
}

std::string run_file_name(std::uint64_t seed) { return fmt::format("run_{:04}.h5", seed); }

}  // namespace clogflow
