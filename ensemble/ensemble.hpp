// Many seeds of one or more scenes, done by all ranks of a call together.
#pragma once

#include "ensemble/enough_seeds.hpp"
#include "ensemble/standing.hpp"
#include "ensemble/worklist.hpp"

namespace clogflow {

struct EnsembleCall {
  std::vector<Ensemble> ensembles;
  Launch launch;
  Ranks* ranks = nullptr;        ///< of an MPI job, or a lone process; nullptr: they know each other by files only
  std::filesystem::path ledger;  ///< file, see ledger.hpp
  std::vector<std::string> inputs = {};      ///< inputs_hash of each ensemble
  std::vector<EnoughSeeds*> decisions = {};  ///< of --until, one an ensemble, or none
};

/// Who is told. With MPI, rank 0 is told of every rank's seeds, the others of nothing.
struct Audience {
  Reporter report;                                                 ///< of every seed
  std::function<void(const Progress&, const Standing&)> progress;  ///< of this rank's run, and of all
};

/// As far as this rank knows; rank 0 knows all.
struct EnsembleResult {
  std::size_t failed = 0;      ///< seeds
  bool complete = true;        ///< every seed is done, failed, or not needed; true for ranks of a launcher
  std::size_t stopped = 0;     ///< seeds whose state was saved; with MPI only, as is
  std::size_t begun = 0;       ///< how many were done or stopped in this call
  std::size_t to_do = 0;       ///< how many were not done before
  int left_to_others = 0;      ///< seeds that another call is at work on
  std::string other;           ///< who
  std::size_t unrecorded = 0;  ///< seeds of this rank that the ledger could not take
  double busy = 0;             ///< of all ranks, at work on seeds [s]
  double duration = 0;         ///< from the begin to the end of this rank's call [s]
};

/// That no directory holds runs or states of another scene. \return lines on what is odd \throws Error otherwise
std::vector<std::string> check_directories(const EnsembleCall& call);

/// Runs the seeds that have no run file yet, each from its saved state if there is one. A seed that fails
/// is reported, leaves its reason in run_NNNN.failed, and does not stop the rest. States are saved every
/// output.checkpoint_interval. A finished run that ends too early is lengthened. Other calls may be at work in the
/// same directories: seeds are shared with them. With MPI: all ranks together.
EnsembleResult run_ensembles(const EnsembleCall& call, const Audience& audience);

}  // namespace clogflow
