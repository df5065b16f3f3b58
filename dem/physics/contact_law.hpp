// A contact law as the solver holds it: which one, its constants, its friction. Knows no law by name; what
// there is stands in contact_laws.hpp.
#pragma once

#include <array>
#include <cstring>
#include <type_traits>

#include "dem/physics/friction.hpp"
#include "dem/physics/laws/contact_materials.hpp"
#include "dem/physics/stiffness.hpp"
#include "dem/physics/time_step.hpp"

namespace clogflow {

struct ContactLaw;

/// The constants of any law: plain numbers, so that a task of the hot loop carries them by value.
class LawConstants {
public:
  LawConstants() = default;

  template <class Law>
  explicit LawConstants(const Law& law) {
    static_assert(sizeof(Law) <= sizeof(numbers_) && std::is_trivially_copyable_v<Law>);
    std::memcpy(numbers_.data(), &law, sizeof(Law));
  }

  /// Inlined wherever it stands: the hot loops are compiled under flags of their own.
  template <class Law>
  [[gnu::always_inline]] Law as() const {
    Law law;
    std::memcpy(static_cast<void*>(&law), numbers_.data(), sizeof(Law));
    return law;
  }

private:
  std::array<double, 8> numbers_{};
};

/// What the solver asks of a law outside the hot loop: one row of the registry.
struct ContactLawRow {
  int number;  ///< of the row, and of its loops in every table of kernels
  ContactLoads<double> (*loads)(const ContactLaw&, const ContactGeometry<double>&, const ContactMotion<double>&,
                                double dt, Springs<double>&);
  double (*stored_energy)(const ContactLaw&, const ContactGeometry<double>&, const Springs<double>&);
  ContactModes (*modes)(const ContactLaw&, const ContactTerms&, const ContactGeometry<double>&);
  double (*overlap_at)(const ContactLaw&, double load, double radius);
  double (*impact_overlap)(const ContactLaw&, double mass, double speed, double radius);
  double (*contact_time)(const ContactLaw&, const Impact&);
  double (*reach)(const ContactLaw&, double radius);
};

struct ContactLaw {
  const ContactLawRow* row = nullptr;
  LawConstants constants;
  FrictionLaw friction;

  /// The law between two species at a place, which tells whether there is friction. \param second  0 for a wall
  ContactLaw at(double x, int first, int second) const {
    ContactLaw there = *this;
    there.friction = friction.between(first, second);
    if (x > friction.ends) there.friction = {};
    return there;
  }

  /// Forces and torques of one contact, all springs on, and the springs one step on.
  ContactLoads<double> loads(const ContactGeometry<double>& g, const ContactMotion<double>& m, double dt,
                             Springs<double>& springs) const {
    return row->loads(*this, g, m, dt, springs);
  }
  /// \return [J]
  double stored_energy(const ContactGeometry<double>& g, const Springs<double>& springs) const {
    return row->stored_energy(*this, g, springs);
  }
  ContactModes modes(const ContactTerms& terms, const ContactGeometry<double>& g) const {
    return row->modes(*this, terms, g);
  }
  /// Overlap at rest under a load [m].
  double overlap_at(double load, double radius) const { return row->overlap_at(*this, load, radius); }
  /// Largest overlap of an elastic impact [m].
  double impact_overlap(double mass, double speed, double radius) const {
    return row->impact_overlap(*this, mass, speed, radius);
  }
  /// Duration of a typical impact, dry and elastic [s].
  double contact_time(const Impact& impact) const { return row->contact_time(*this, impact); }
  /// Gap up to which a contact lasts once it has begun [m].
  double reach(double radius) const { return row->reach(*this, radius); }
};

}  // namespace clogflow
