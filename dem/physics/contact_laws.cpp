#include "dem/physics/contact_laws.hpp"

#include <array>
#include <string>

#include "coupling/base/require.hpp"

namespace clogflow {

namespace {

constexpr ContactTerms all{true, true, true, true};

template <class Kind>
constexpr ContactLawRow make_row(int number) {
  using Law = typename Kind::Normal;
  using Turning = typename Kind::Turning;
  return {
      .number = number,
      .loads =
          [](const ContactLaw& law, const ContactGeometry<double>& g, const ContactMotion<double>& m, double dt,
             Springs<double>& springs) {
            return contact_loads<Turning, all>(law.constants.as<Law>(), law.friction, g, m, dt, springs);
          },
      .stored_energy =
          [](const ContactLaw& law, const ContactGeometry<double>& g, const Springs<double>& springs) {
            return clogflow::stored_energy<Turning>(law.constants.as<Law>(), g, springs);
          },
      .modes =
          [](const ContactLaw& law, const ContactTerms& terms, const ContactGeometry<double>& g) {
            return contact_modes<Turning>(law.constants.as<Law>(), terms, g);
          },
      .overlap_at = [](const ContactLaw& law, double load,
                       double radius) { return law.constants.as<Law>().overlap_at(load, radius); },
      .impact_overlap = [](const ContactLaw& law, double mass, double speed,
                           double radius) { return law.constants.as<Law>().impact_overlap(mass, speed, radius); },
      .contact_time = [](const ContactLaw& law,
                         const Impact& impact) { return law.constants.as<Law>().contact_time(impact); },
      .reach = [](const ContactLaw& law, double radius) { return law.constants.as<Law>().reach(radius); },
  };
}

/// What a scene calls a row, and how its constants are made.
struct NamedRow {
  std::string_view law, turning;
  ContactTraits traits;
  LawConstants (*constants)(const ContactMaterials&);
  ContactLawRow row;
};

template <class... Kinds>
constexpr auto make_rows(KindList<Kinds...>) {
  int number = 0;
  return std::array{NamedRow{Kinds::Normal::word, Kinds::Turning::word, Kinds::Normal::traits,
                             [](const ContactMaterials& m) { return LawConstants(Kinds::Normal::of(m)); },
                             make_row<Kinds>(number++)}...};
}

const auto contact_law_rows = make_rows(ContactKinds{});

}  // namespace

ContactLaw make_contact_law(std::string_view law, std::string_view turning, const ContactMaterials& materials,
                            const FrictionLaw& friction) {
  std::string there;
  for (const NamedRow& row : contact_law_rows) {
    if (row.law == law && row.turning == turning) return {&row.row, row.constants(materials), friction};
    if (row.law == law) there += fmt::format("{}\"{}\"", there.empty() ? "" : ", ", row.turning);
  }
  throw Error(
      fmt::format("contact.law = \"{}\" has no rolling and torsion as \"{}\" (there is {})", law, turning, there));
}

ContactTraits contact_traits(std::string_view law) {
  for (const NamedRow& row : contact_law_rows)
    if (row.law == law) return row.traits;
  throw Error(fmt::format("there is no contact.law = \"{}\"", law));
}

}  // namespace clogflow
