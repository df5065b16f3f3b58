// One run: the state of one seed and its steps.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>

#include "coupling/files/run_file.hpp"
#include "dem/contact/neighbours.hpp"
#include "dem/contact/wall_contacts.hpp"
#include "dem/fluid/films.hpp"
#include "dem/fluid/fluid.hpp"
#include "dem/kernels/kernels.hpp"
#include "dem/run/clog_watch.hpp"
#include "dem/run/inlet.hpp"
#include "dem/run/model.hpp"
#include "dem/stability/network_limit.hpp"
#include "dem/stability/step_watch.hpp"
#include "dem/state/particles.hpp"
#include "dem/state/random.hpp"

namespace clogflow {

/// What a watcher is told now and then.
struct Progress {
  double time = 0, end = 0;   ///< simulated; negative while the channel is filled [s]
  std::int64_t steps = 0;     ///< done
  double particle_steps = 0;  ///< done
  std::size_t particles = 0;
  std::size_t passages = 0;
  bool clogged = false;  ///< nothing passed for half a tau
  bool filling = false;
};
using Watcher = std::function<void(const Progress&)>;

/// Velocity Verlet in its leapfrog form: positions at full steps, velocities half a step before, so
/// that one kick and one drift make a step:
///   F_n = F(x_n, v_(n-1/2));  v_(n+1/2) = v_(n-1/2) + F_n / m dt;  x_(n+1) = x_n + v_(n+1/2) dt
/// which is the usual two half kicks with the forces taken at the half-step velocity between them.
class Simulation {
public:
  /// \param flow  nullptr without an OpenFOAM flow; must outlive the simulation
  Simulation(const Scene& scene, const FlowGrid* flow, std::uint64_t seed);

  /// The same from the given particles, whatever file the scene names; masses as the scene says.
  Simulation(const Scene& scene, const FlowGrid* flow, std::uint64_t seed, const std::vector<Particle>& initial);

  /// Runs to the end. \throws Error if it blows up or loses a particle
  RunData run(const Watcher& watcher = {});

  /// Who is told, in one line, of the step's limits and of a step near them.
  void on_note(std::function<void(const std::string&)> say) { say_ = std::move(say); }

  /// While it is true the watcher is called at every step, not only now and then; must outlive the run.
  void hurry_when(const std::atomic<bool>* asked) { hurry_ = asked; }

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
  void advance();                     ///< kick, drift, passages, time
  void record();                      ///< series, snapshots, release protocol: what is due now

  const Model& model() const { return model_; }
  const Particles& particles() const { return particles_; }
  Particles& particles() { return particles_; }
  const RunData& data() const { return data_; }
  double time() const { return static_cast<double>(step_) * model_.dt; }
  const ContactTally& pair_tally() const { return pair_tally_; }
  const ContactTally& wall_tally() const { return wall_tally_; }

private:
  /// A filled start: the pack settles against the gate, is tapped, settles again ... until it
  /// opens.
  struct Filling {
    enum class Stage { before, settle, tap, done };
    Stage stage = Stage::before;
    int taps = 0;                                               ///< done
    double stage_began = 0, last_insertion = 0, next_look = 0;  ///< [s]
    double duration = 0;                                        ///< of the whole filling [s]
    bool at_rest = true;                                        ///< when the gate opened

    template <class Archive>
    void exchange(Archive& archive) {
      archive(stage, taps, stage_began, last_insertion, next_look, duration, at_rest);
    }
  };

  void begin_filling();
  void enter_filling(Filling::Stage stage);
  bool settled();
  void open_gate();
  void set_walls(bool gate_closed);
  void feed_inlet(double time);
  bool is_watched() const;  ///< at this step
  void take_out();
  void rebuild_lists();
  void sort_candidates();
  void announce_step();     ///< \throws Error if the step is too large
  void watch_step();        ///< now and then: the limit of the contacts, and energy from nothing
  void look_at_limit();     ///< \throws Error if the run begins above it
  void look_for_shaking();  ///< whether the pack moves between whole steps but not at them
  void check_overlap();     ///< warns of deep contacts. \throws Error if they are pressed too deep
  int fastest() const;      ///< the fastest particle, or the first whose velocity is no number
  struct Deepest {
    int particle = 0, other = -1;  ///< other < 0: a wall
    double overlap = 0;            ///< [m]
  };
  double largest_overlap() const { return std::max(pair_tally_.largest_overlap, wall_tally_.largest_overlap); }  // [m]
  Deepest deepest() const;  ///< the deepest contact
  std::string describe_contact(const Deepest& contact) const;
  std::string remedy(const ParticleState& worst) const;
  [[noreturn]] void blow_up(const char* cause, int particle) const;
  void add_pair(NetworkLimit& network, int i, int j) const;
  std::vector<Film> films() const;
  AdvanceTask advance_task();
  /// The first kick leads from time 0 to half a step; all later ones from half step to half step.
  double next_kick() const { return kick_ == 0 ? model_.dt / 2 : model_.dt; }
  std::string save_end();                  ///< for RunData::end_state; what was recorded is left to the run file
  void take_up(RunData recorded);          ///< fits a state that was read to our scene
  double next_due(double interval) const;  ///< as if things had been recorded at that interval from the start [s]
  void check_resumed() const;              ///< \throws Error unless a state read is one that a run can have
  void find_passages();
  void set_friction(bool on);
  void sample_series();
  void sample_snapshot();
  Vector<double> velocity_now(int i) const;  ///< at the time of the positions
  Vector<double> spin_now(int i) const;
  Vector<double> total_force(int i) const;
  void count_seconds();
  void finish();

  template <class Archive>
  void exchange(Archive& archive) {
    archive(gate_closed_);
    if (Archive::loading && gate_closed_) set_walls(true);
    archive(random_, inlet_, watch_, particles_, neighbours_, walls_, fluid_, data_, step_, kick_, drifted_, way_,
            margin_, drifted_when_sorted_, lists_stale_, lists_are_new_, next_insertion_, next_porosity_, next_series_,
            next_snapshot_, particle_steps_, drag_work_, body_work_, energy_in_, filling_, step_watch_, seconds_);
    if (Archive::loading) {
      neighbours_.measure(particles_);
      set_friction(filling_.stage != Filling::Stage::tap && !watch_.friction_off());
    }
  }

  Model model_;
  Fluid fluid_;
  const Kernels& kernels_;
  Random random_;
  Inlet inlet_;
  ClogWatch watch_;
  Particles particles_;
  Neighbours neighbours_;
  WallContacts walls_;
  ContactLaw pair_law_, wall_law_;  // as of now: without friction during a release
  ContactTally pair_tally_, wall_tally_;
  std::vector<std::uint8_t> leaving_;
  double largest_radius_ = 0;  // of any particle that will be [m]
  std::int64_t given_ = 0;     // initial particles, which have the first ids
  RunData data_;
  std::int64_t step_ = 0;
  double kick_ = 0;     // dt, or dt/2 in the very first step: the velocities given are at x_0
  double drifted_ = 0;  // bound on any particle's way since the lists were made [m]
  double way_ = 0;      // of the fastest particle in the last step [m]
  double margin_ = 0;   // gaps may change by this much before the candidates are sorted anew [m]
  double drifted_when_sorted_ = 0;
  bool lists_stale_ = true, lists_are_new_ = false;
  bool loads_used_ = true;  // the loads are those of the present positions, not yet cleared
  double next_insertion_ = 0, next_porosity_ = 0, next_series_ = 0, next_snapshot_ = 0;
  double particle_steps_ = 0;
  double drag_work_ = 0, body_work_ = 0;
  double energy_in_ = 0;  // kinetic and elastic energy at the start, and of what came and went [J]
  Filling filling_;
  StepWatch step_watch_;
  std::function<void(const std::string&)> say_;
  const std::atomic<bool>* hurry_ = nullptr;
  bool gate_closed_ = false;
  using Clock = std::chrono::steady_clock;
  double seconds_ = 0;  // of wall-clock time spent before clock_ [s]
  Clock::time_point clock_ = Clock::now();
};

}  // namespace clogflow
