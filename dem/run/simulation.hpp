// One run: the state of one seed and its steps.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "coupling/files/run_file.hpp"
#include "dem/run/energy_account.hpp"
#include "dem/run/progress.hpp"
#include "dem/run/recorder.hpp"
#include "dem/run/run_state.hpp"
#include "dem/run/stability_watch.hpp"
#include "dem/stability/network_limit.hpp"

namespace clogflow {

/// Velocity Verlet in its leapfrog form: positions at full steps, velocities half a step before, so
/// that one kick and one drift make a step:
///   F_n = F(x_n, v_(n-1/2));  v_(n+1/2) = v_(n-1/2) + F_n / m dt;  x_(n+1) = x_n + v_(n+1/2) dt
/// which is the usual two half kicks with the forces taken at the half-step velocity between them.
class Simulation {
public:
  /// \param flow     nullptr without an OpenFOAM flow; must outlive the simulation
  /// \param threads  share the work of a step; the same bits come out for any number
  Simulation(const Scene& scene, const FlowGrid* flow, std::uint64_t seed, int threads = 1);

  /// The same from the given particles, whatever file the scene names; masses as the scene says.
  Simulation(const Scene& scene, const FlowGrid* flow, std::uint64_t seed, const std::vector<Particle>& initial,
             int threads = 1);

  /// Runs to the end. \throws Error if it blows up or loses a particle
  RunData run(const Watcher& watcher = {});

  /// Who is told, in one line, of the step's limits and of a step near them.
  void on_note(Say say) { stability_.tell(std::move(say)); }

  /// While it is true the watcher is called at every step, not only now and then; must outlive the run.
  void hurry_when(const std::atomic<bool>* asked) { hurry_ = asked; }

  /// From the next forces on, what contacts, films and drag do with the energy is counted term by term, at the price of
  /// many steps each; for tests and studies. \throws Error for laws whose contacts stick
  void account_for_energy() { account_ = std::make_unique<EnergyAccount>(model_); }
  const EnergyAccount& energy_account() const { return *account_; }

  /// The present contacts, films and drag, which know their largest stable step; after compute_forces().
  NetworkLimit network() const;

  double elastic_energy() const;  ///< of all springs, after compute_forces() [J]
  double kinetic_energy() const;  ///< at the time of the positions [J]

  /// The state goes on from time 0 with another step; for studies of the step, of scenes without an inlet.
  void change_step(double dt);

  /// Everything that the next step depends on, and all that was recorded, as bytes; between two
  /// steps only, that is from a watcher. A simulation of the same seed that resumes from it goes on with the
  /// same bits, if its scene differs at most in keys that decide no trajectory (coupling/scene/scene_difference.hpp).
  /// \throws Error if the bytes are no such state; StateRefused if the run they belong to is another
  std::string save();
  void resume(const std::string& state);

  /// Goes on from RunData::end_state of a finished run, and what it recorded. \throws as resume()
  void lengthen(RunData done, const std::string& end_state);

  /// The loop of run(), in pieces, for tests and studies.
  void fill(const Watcher& watcher);  ///< packs the channel against the gate, then opens it
  void compute_forces();              ///< F_n of the present positions
  void record();                      ///< series, snapshots, release protocol: what is due now
  void advance();                     ///< kick, drift, passages, time

  const Model& model() const { return model_; }
  const RunState& state() const { return state_; }
  const Particles& particles() const { return state_.particles; }
  Particles& particles() { return state_.particles; }
  const RunData& data() const { return recorder_.data; }
  double time() const { return state_.time(); }
  const ContactTally& pair_tally() const { return state_.pair_tally; }
  const ContactTally& wall_tally() const { return state_.wall_tally; }

private:
  void begin_filling();
  void begin_run();
  void tell(const Watcher& watcher) const;
  void finish();

  const Model model_;
  const Kernels& kernels_;
  RunState state_;
  Recorder recorder_;
  StabilityWatch stability_;
  std::unique_ptr<EnergyAccount> account_;
  const std::atomic<bool>* hurry_ = nullptr;
};

}  // namespace clogflow
