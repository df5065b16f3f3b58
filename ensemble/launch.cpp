#include "ensemble/launch.hpp"

#include <chrono>
#include <optional>

#include <unistd.h>

#include "coupling/base/environment.hpp"
#include "coupling/base/require.hpp"

namespace clogflow {

namespace {

std::optional<int> number(const char* name) {
  return environment_number(
      name, "(the environment of a launcher must hold a whole number): unset it, or start under mpirun or srun");
}

/// Names of rank and number of ranks; `condition` must be there too. The batch script of Slurm is no step: it
/// has the variables of a rank and is none.
struct Launcher {
  const char *rank, *count, *condition, *call;
};

constexpr Launcher launchers[] = {
    {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK", "PMIX_NAMESPACE"},
    {"PMI_RANK", "PMI_SIZE", "PMI_RANK", "PMI_JOBID"},
    {"SLURM_PROCID", "SLURM_NTASKS", "SLURM_STEP_ID", "SLURM_STEP_ID"},
};

std::string host_name() {
  char name[256] = "";
  ::gethostname(name, sizeof name - 1);
  return name;
}

std::string call_of(const Launcher& launcher) {
  std::string call = environment(launcher.call).value_or("");
  // The key is random; the other names repeat where process numbers do, as in containers.
  for (const char* name : {"OMPI_MCA_orte_precondition_transports", "SLURM_JOB_ID", "SLURM_RESTART_COUNT"})
    if (const auto value = environment(name)) call += "." + *value;
  return call;
}

/// Of this process and no other.
std::string own_name(const std::string& host) {
  return fmt::format("{}.{}.{}", host, ::getpid(), std::chrono::system_clock::now().time_since_epoch().count());
}

}  // namespace

Launch launch_of(Ranks& ranks) {
  const std::string host = host_name();
  return {.rank = ranks.rank(),
          .count = ranks.count(),
          .by_launcher = ranks.launched(),
          .call = ranks.of_first(own_name(host)),
          .host = host};
}

Launch launch_from_environment() {
  Launch launch;
  launch.host = host_name();
  for (const Launcher& launcher : launchers) {
    const auto rank = number(launcher.rank), count = number(launcher.count);
    if (!rank || !count || !environment(launcher.condition)) continue;
    require(*rank < *count, "{} = {} (must be below {} = {}): unset both, or start under mpirun or srun", launcher.rank,
            *rank, launcher.count, *count);
    launch.rank = *rank, launch.count = *count, launch.call = call_of(launcher), launch.by_launcher = true;
    break;
  }
  if (launch.call.empty()) launch.call = own_name(launch.host);
  return launch;
}

}  // namespace clogflow
