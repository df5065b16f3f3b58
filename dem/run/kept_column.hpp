// The column as it was when friction began last, for restarts that go back to it.
#pragma once

#include <cmath>
#include <string>

namespace clogflow {

struct RunState;

/// The protocol "rewind" puts the column back to where friction began, and lets it flow on from there. So what
/// flows without friction is one long flow in which no clog ever stood, and every burst is a branch of it: there is no
/// clog to forget, and a strain that is short but makes the next burst another one is enough.
/// Neglects nothing but time: clock, inlet and random numbers go on, so what comes in is not what came in before.
class KeptColumn {
public:
  /// Between two steps.
  void keep(RunState& state);

  /// Between two steps: particles and contacts are those of then, their numbers too. \throws Error if what is kept was
  /// read from a damaged state
  void put_back(RunState& state) const;

  /// After the forces, which alone know what the contacts store: the energy of what was kept, or of the clog that is to
  /// go. So the balance of energies does not take the one for the other.
  void weigh(const RunState& state);

  bool valid() const { return std::isfinite(energy_) && std::isfinite(energy_of_clog_); }

  template <class Archive>
  void exchange(Archive& archive) {
    archive(bytes_, is_weighed_, energy_, energy_of_clog_);
  }

private:
  std::string bytes_;  // of particles and lists
  bool is_weighed_ = true;
  double energy_ = 0, energy_of_clog_ = 0;  // kinetic and elastic [J]
};

/// What the clog watch asks for before the next forces: the column goes back, or is kept.
void go_back_or_keep(RunState& state);

}  // namespace clogflow
