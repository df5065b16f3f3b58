// What contacts, films, drag and body force each do with the energy, counted on its own.
#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include "coupling/base/vector.hpp"
#include "dem/run/run_state.hpp"

namespace clogflow {

/// Energies since the account was opened [J], or powers [W].
struct EnergyTerms {
  double dashpots = 0;    ///< dissipated by the dashpots beside all springs
  double sliders = 0;     ///< dissipated by springs that Coulomb's limit cuts back
  double films = 0;       ///< dissipated by lubrication
  double stiffening = 0;  ///< put into the sliding, rolling and torsion springs where their stiffness grows with the
                          ///< overlap, which no work does; negative where they soften or a contact opens
  double drag = 0;        ///< work of the fluid, its torque too
  double body_force = 0;  ///< work of body_force and weight

  /// What left the particles and their springs: kinetic + elastic energy + lost() stays as it is.
  double lost() const { return dashpots + sliders + films - stiffening - drag - body_force; }
};

/// Goes over all contacts with the scalar laws, far outside the hot loop, and integrates the power of each term with
/// the trapezoidal rule. Nothing here is the rest of a balance: the sum closes to first order in the step, or a term
/// is wrong. Neglects the energy of particles that come and go (EnergyBalance::brought has it), and that touches of
/// curved walls change their share of a load.
class EnergyAccount {
public:
  /// \throws Error for laws whose contacts stick: they begin and end with a jump of energy
  explicit EnergyAccount(const Model& model);

  /// After the forces of every step.
  void look(const RunState& state);

  const EnergyTerms& terms() const { return terms_; }

private:
  struct Contact;

  /// A contact as it was a step ago.
  struct Known {
    Vec3 place;               // on the wall; of no use for a pair [m]
    Springs<double> springs;  // as the particle with the lower number sees them
    double spring_energy;     // all but the normal spring's [J]
  };
  using Memory = std::multimap<std::pair<std::int64_t, std::int64_t>, Known>;  // by numbers; a wall is -1

  void add_pairs(const RunState& state);
  void add_walls(const RunState& state);
  void add_contact(const RunState& state, const Contact& contact);
  void add_films(const RunState& state);
  void add_particles(const RunState& state);
  void integrate(double dt);

  const Model& model_;
  EnergyTerms terms_, power_, last_power_;
  Memory before_, now_;
  bool has_last_power_ = false;
};

}  // namespace clogflow
