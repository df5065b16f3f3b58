// The registry of contact laws: the one place, besides a law's own file, that knows it.
#pragma once

#include <string_view>

#include "dem/physics/contact_law.hpp"
#include "dem/physics/laws/dmt.hpp"
#include "dem/physics/laws/hertz.hpp"
#include "dem/physics/laws/hooke.hpp"
#include "dem/physics/laws/jkr.hpp"

namespace clogflow {

/// Which loops are compiled for a row: one for each set of frictions and for equal spheres, or a single one
/// for all, in which a friction of zero costs what any other does.
enum class Loops { tailored, single };

template <class Law, class RollingAndTorsion, Loops compiled>
struct ContactKind {
  using Normal = Law;
  using Turning = RollingAndTorsion;
  static constexpr Loops loops = compiled;
};

template <class... Kinds>
struct KindList {
  static constexpr int size = sizeof...(Kinds);
};

/// The rows. A scene names the first two of each: contact.law, and how rolling and torsion turn.
using ContactKinds =
    KindList<ContactKind<Hertz, LudingTurning, Loops::tailored>, ContactKind<Hertz, MercuryTurning, Loops::single>,
             ContactKind<Hertz, DoublingTurning, Loops::single>, ContactKind<Hooke, LudingTurning, Loops::single>,
             ContactKind<Jkr, LudingTurning, Loops::single>, ContactKind<Dmt, LudingTurning, Loops::single>>;

/// The row of a law and a way of turning, with its constants.
/// \throws Error if there is no such row
ContactLaw make_contact_law(std::string_view law, std::string_view turning, const ContactMaterials& materials,
                            const FrictionLaw& friction);

/// What a law says of itself. \throws Error if there is no such law
ContactTraits contact_traits(std::string_view law);

}  // namespace clogflow
