// The column as it was when friction began last, for restarts that go back to it.
#pragma once

#include <string>

namespace clogflow {

struct RunState;

/// A restart with `unclog.rewind` puts the column back to where friction began, and lets it flow on from there. So what
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

  template <class Archive>
  void exchange(Archive& archive) {
    archive(bytes_);
  }

private:
  std::string bytes_;  // of particles and lists
};

/// At the clog of a restart that goes back, and where friction begins; the watch hears of it.
void go_back(RunState& state);
void keep_column(RunState& state);

}  // namespace clogflow
