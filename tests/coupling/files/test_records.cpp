// The records of run and flow files: the tables of their entries, their text, and what is refused.
#include <gmock/gmock.h>

#include "coupling/files/record_json.hpp"
#include "tests/coupling/openfoam/sample_files.hpp"
#include "tests/coupling/refusal.hpp"

namespace clogflow {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

constexpr const char* place = "/provenance/record";
const FileFormat format{.name = "record", .version = 1};

template <class Record>
Record there_and_back(const Record& record) {
  const auto file = temporary("record.h5");
  Hdf5Writer out(file, format);
  write_record(out, record);
  out.finish();
  return read_record<Record>(Hdf5Reader(file, format));
}

template <class Record>
std::string text_of(const Record& record) {
  there_and_back(record);
  return Hdf5Reader(temporary("record.h5"), format).read_text(place);
}

template <class Record>
Record read_text(const std::string& text) {
  const auto file = temporary("text.h5");
  Hdf5Writer out(file, format);
  out.write_text(place, text);
  out.finish();
  return read_record<Record>(Hdf5Reader(file, format));
}

RunRecord whole_run_record() {
  RunRecord record;
  record.program = "clogflow 0.1.0";
  record.fill_at_rest = true;
  record.inserted = 112;
  record.particle_steps = 3194447;
  record.fill_time = 0.07774704049844237;
  record.shaking_speed = 0;
  record.others["weather"] = R"({"rain":[1,2.5]})";
  return record;
}

FlowRecord whole_flow_record() {
  FlowRecord record;
  record.iterations = 147;
  record.cells = 2190;
  record.residuals = {.ux = 1e-7, .uy = 2e-7, .uz = 3e-7, .p = 4e-7};
  record.mass_flux = {{"inlet", 2e-10, 0}, {"outlet", 2.5e-10, 0.25}};
  record.grid_flux = std::vector<PlaneFlux>{};
  record.mesh_error = MeshError{.cells_per_neck = {16, 12}, .extrapolated = true, .velocity_rms = 0.5};
  record.rescaled = {.from = "0123", .factor = 2, .error = 0.125};
  record.others["solver"] = "\"mine \u00b5\"";
  return record;
}

TEST(RunRecord, IsTextInOrderOfTheAlphabet) {
  EXPECT_EQ(text_of(whole_run_record()), R"({
  "fill_at_rest": true,
  "fill_time_s": 0.07774704049844237,
  "inserted": 112,
  "particle_steps": 3194447.0,
  "program": "clogflow 0.1.0",
  "shaking_speed_m_s": 0.0,
  "weather": {
    "rain": [
      1,
      2.5
    ]
  }
})");
  EXPECT_EQ(text_of(RunRecord{}), "null");
}

TEST(FlowRecord, IsTextInOrderOfTheAlphabet) {
  FlowRecord record = whole_flow_record();
  record.mesh_error.reset();
  record.mass_flux->pop_back();
  EXPECT_EQ(text_of(record), R"({
  "cells": 2190,
  "grid_flux": [],
  "iterations": 147.0,
  "mass_flux": [
    {
      "error": 0.0,
      "flux": 2e-10,
      "surface": "inlet"
    }
  ],
  "rescaled": {
    "error": 0.125,
    "factor": 2.0,
    "from": "0123"
  },
  "residuals": {
    "Ux": 1e-07,
    "Uy": 2e-07,
    "Uz": 3e-07,
    "p": 4e-07
  },
  "solver": "mine µ"
})");
}

TEST(Records, ThereAndBack) {
  EXPECT_EQ(there_and_back(whole_run_record()), whole_run_record());
  EXPECT_EQ(there_and_back(whole_flow_record()), whole_flow_record());
  EXPECT_EQ(there_and_back(RunRecord{}), RunRecord{});
  EXPECT_EQ(read_text<FlowRecord>("{}"), FlowRecord{});
  EXPECT_EQ(run_record_of(record_text(whole_run_record())), whole_run_record());
}

// A name in the file must not say another unit than the table, nor the table forget one.
template <class Record>
void expect_units_in_names() {
  for_each_entry<Record>([](const auto& entry) {
    const std::string name = entry.name, unit = entry.unit;
    if (unit == "s") {
      EXPECT_THAT(name, EndsWith("_s"));
    }
    if (unit == "m/s") {
      EXPECT_THAT(name, EndsWith("_m_s"));
    }
    if (unit == "1/s") {
      EXPECT_THAT(name, EndsWith("_per_s"));
    }
    if (name.ends_with("_s")) {
      EXPECT_THAT(unit, EndsWith("s"));
    }
  });
}

TEST(Records, NamesSayTheirUnits) {
  expect_units_in_names<RunRecord>();
  expect_units_in_names<FlowRecord>();
  EXPECT_STREQ(entry_name(&RunRecord::contact_limit), "contact_limit_s");
  EXPECT_STREQ(entry_name(&RunRecord::inputs_hash), "inputs_hash");
}

TEST(Records, RefuseOtherKinds) {
  const auto run = [](const char* text) { return refusal([&] { read_text<RunRecord>(text); }); };
  EXPECT_THAT(run(R"({"fill_at_rest": 1})"), HasSubstr("/provenance/record: fill_at_rest is no true or false"));
  EXPECT_THAT(run(R"({"inserted": 1.5})"), HasSubstr("inserted is no whole number"));
  EXPECT_THAT(run(R"({"host": 1})"), HasSubstr("host is no text"));
  const auto flow = [](const char* text) { return refusal([&] { read_text<FlowRecord>(text); }); };
  EXPECT_THAT(flow(R"({"pressure_drop": "much"})"), HasSubstr("pressure_drop is no number"));
  EXPECT_THAT(flow(R"({"mass_flux": 3})"), HasSubstr("mass_flux is no list"));
  EXPECT_THAT(flow(R"({"mass_flux": [3]})"), HasSubstr("mass_flux is no JSON object"));
  EXPECT_THAT(flow(R"({"rescaled": {"from": "0123"}})"), HasSubstr("rescaled: factor is missing"));
  EXPECT_THAT(refusal([] { run_record_of("["); }), HasSubstr("a saved state is damaged"));
}

}  // namespace
}  // namespace clogflow
