#include "ensemble/ranks.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <deque>
#include <exception>
#include <filesystem>
#include <utility>

#include <mpi.h>
#include <signal.h>
#include <unistd.h>

#include "coupling/base/environment.hpp"
#include "coupling/base/expect.hpp"
#include "coupling/base/require.hpp"
#include "ensemble/nap.hpp"

namespace clogflow {

namespace {

constexpr int line_tag = 1, want_tag = 2, number_tag = 3;
constexpr std::chrono::seconds between_roll_calls{1};
constexpr std::chrono::milliseconds longest_passing{2}, longest_idle{20};
constexpr std::size_t own_of_mpi = std::size_t{4} << 20;  // beside the numbers, in shared memory [byte]
constexpr std::size_t numbers_per_message = std::size_t{1} << 28;

/// MPI is started only under mpirun or srun: a lone process needs none of it.
bool launched_by_mpi() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"})
    if (environment(name)) return true;
  return false;
}

/// What would end in as many jobs of one rank, or in ranks that wait for a dead one.
void check_launcher() {
  const char* wanted = "wants --no-mpi: a rank that dies would leave the others waiting";
  require(environment("OMPI_MCA_orte_enable_recovery").value_or("0") != "1", "mpirun --enable-recovery ({})", wanted);
  if (launched_by_mpi() || !environment("SLURM_STEP_ID")) return;
  const std::string tasks = environment("SLURM_NTASKS").value_or("1");
  if (tasks == "1") return;
  // Once for all of them.
  require(environment("SLURM_PROCID").value_or("0") == "0", "");
  throw Error(
      fmt::format("srun started {} processes and gives MPI no means to bring them together: give srun "
                  "--mpi=pmix, or clog run --no-mpi",
                  tasks));
}

void patiently(MPI_Request& request) {
  for (Nap nap(longest_passing);; nap()) {
    int done = 0;
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done) return;
  }
}

/// Open MPI would tell one rank, and let the others wait for it.
void require_shared_memory(std::size_t bytes) {
  std::error_code none;
  const auto space = std::filesystem::space("/dev/shm", none);
  require(none || bytes + own_of_mpi < space.available,
          "/dev/shm has room for {} MB, and the flow takes {} there: enlarge it, or give --no-mpi",
          space.available >> 20, (bytes + own_of_mpi) >> 20);
}

template <class Begin>
void broadcast_in_parts(std::size_t size, const Begin& begin) {
  for (std::size_t at = 0; at < size; at += numbers_per_message) {
    MPI_Request request = MPI_REQUEST_NULL;
    begin(at, static_cast<int>(std::min(numbers_per_message, size - at)), &request);
    patiently(request);
  }
}

/// Of rank 0, on all.
std::size_t common_size(std::size_t of_first) {
  std::uint64_t size = of_first;
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibcast(&size, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD, &request);
  patiently(request);
  return size;
}

}  // namespace

struct Ranks::Job {
  /// A line on its way. It has arrived when rank 0 has taken it.
  struct Letter {
    std::string text;
    MPI_Request request = MPI_REQUEST_NULL;
  };

  /// Memory of a node, mapped by its ranks; freed by all of them together.
  struct NodeMemory {
    MPI_Comm node = MPI_COMM_NULL;
    MPI_Win window = MPI_WIN_NULL;
    float* numbers = nullptr;
  };

  MPI_Win window = MPI_WIN_NULL;  // of the counter, if one-sided communication exists between all ranks
  int* counter = nullptr;
  int own_counter = 0;  // of rank 0, if not
  std::deque<Letter> letters;
  std::vector<std::string> arrived;
  MPI_Request sum = MPI_REQUEST_NULL;
  std::vector<double> mine, total;
  std::vector<NodeMemory> memories;
  std::vector<int> processes;  // of this node
  std::chrono::steady_clock::time_point last_roll_call = std::chrono::steady_clock::now();

  static std::optional<MPI_Status> source_of(int tag) {
    int is_there = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, tag, MPI_COMM_WORLD, &is_there, &status);
    return is_there ? std::optional(status) : std::nullopt;
  }

  void take_line(const MPI_Status& from) {
    int size = 0;
    MPI_Get_count(&from, MPI_CHAR, &size);
    std::string text(static_cast<std::size_t>(size), ' ');
    MPI_Recv(text.data(), size, MPI_CHAR, from.MPI_SOURCE, line_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    arrived.push_back(std::move(text));
  }

  void answer(const MPI_Status& from) {
    MPI_Recv(nullptr, 0, MPI_INT, from.MPI_SOURCE, want_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    // The other waits for it: it is taken at once.
    MPI_Send(&own_counter, 1, MPI_INT, from.MPI_SOURCE, number_tag, MPI_COMM_WORLD);
    ++own_counter;
  }

  void name_processes() {
    MPI_Comm node;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node);
    int count = 0;
    const int own = ::getpid();
    MPI_Comm_size(node, &count);
    processes.resize(static_cast<std::size_t>(count));
    MPI_Allgather(&own, 1, MPI_INT, processes.data(), 1, MPI_INT, node);
    MPI_Comm_free(&node);
  }

  /// srun lets the others wait for one that died, unless told otherwise. \return its number, or 0
  int dead_process() {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_roll_call < between_roll_calls) return 0;
    last_roll_call = now;
    for (const int process : processes)
      if (::kill(process, 0) != 0 && errno == ESRCH) return process;
    return 0;
  }

  int asked() {
    int mine = 0;
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Irecv(&mine, 1, MPI_INT, 0, number_tag, MPI_COMM_WORLD, &request);
    MPI_Send(nullptr, 0, MPI_INT, 0, want_tag, MPI_COMM_WORLD);
    patiently(request);
    return mine;
  }

  /// Debian's Open MPI has no one-sided communication over TCP.
  void open_counter(int rank) {
    MPI_Comm own;
    MPI_Comm_dup(MPI_COMM_WORLD, &own);
    MPI_Comm_set_errhandler(own, MPI_ERRORS_RETURN);
    const MPI_Aint size = rank == 0 ? sizeof(int) : 0;
    int mine = MPI_Win_allocate(size, sizeof(int), MPI_INFO_NULL, own, &counter, &window) == MPI_SUCCESS, all = 0;
    MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
    MPI_Comm_free(&own);
    if (!all) {
      window = MPI_WIN_NULL;
      return;
    }
    if (rank == 0) *counter = 0;
    MPI_Barrier(MPI_COMM_WORLD);
    MPI_Win_lock_all(0, window);
  }

  /// Over TCP a rank is reached only while it is inside MPI: any call will do.
  void look() {
    while (const auto from = source_of(line_tag)) take_line(*from);
    while (const auto from = source_of(want_tag)) answer(*from);
    for (int done = 1; done && !letters.empty();) {
      MPI_Test(&letters.front().request, &done, MPI_STATUS_IGNORE);
      if (done) letters.pop_front();
    }
  }
};

Ranks::Ranks(Use use) {
  if (use == Use::none) return;
  check_launcher();
  if (!launched_by_mpi()) return;
  MPI_Init(nullptr, nullptr);
  job_ = std::make_unique<Job>();
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &count_);
  job_->open_counter(rank_);
  job_->name_processes();
}

Ranks::~Ranks() {
  if (!job_) return;
  for (Job::NodeMemory& memory : job_->memories) {
    MPI_Win_free(&memory.window);
    MPI_Comm_free(&memory.node);
  }
  if (job_->window != MPI_WIN_NULL) {
    MPI_Win_unlock_all(job_->window);
    MPI_Win_free(&job_->window);
  }
  MPI_Finalize();
}

int Ranks::next() {
  if (!job_) return taken_++;
  if (job_->window == MPI_WIN_NULL) return rank_ == 0 ? job_->own_counter++ : job_->asked();
  const int one = 1;
  int mine = 0;
  MPI_Fetch_and_op(&one, &mine, MPI_INT, 0, 0, MPI_SUM, job_->window);
  MPI_Win_flush(0, job_->window);
  return mine;
}

void Ranks::serve() {
  if (!job_) return;
  job_->look();
  if (const int process = job_->dead_process())
    abandon(fmt::format("process {} of this job has died; the next call goes on from the saved states", process));
}

void Ranks::tell_first(const std::string& line) {
  expect(job_ && rank_ != 0);
  Job::Letter& letter = job_->letters.emplace_back();
  letter.text = line;
  MPI_Issend(letter.text.data(), static_cast<int>(letter.text.size()), MPI_CHAR, 0, line_tag, MPI_COMM_WORLD,
             &letter.request);
}

std::vector<std::string> Ranks::told() {
  serve();
  return job_ ? std::exchange(job_->arrived, {}) : std::vector<std::string>{};
}

void Ranks::begin_sum(std::vector<double> mine) {
  if (!job_) {
    alone_ = std::move(mine);
    return;
  }
  expect(job_->sum == MPI_REQUEST_NULL);
  job_->mine = std::move(mine);
  job_->total.resize(job_->mine.size());
  MPI_Iallreduce(job_->mine.data(), job_->total.data(), static_cast<int>(job_->mine.size()), MPI_DOUBLE, MPI_SUM,
                 MPI_COMM_WORLD, &job_->sum);
}

std::optional<std::vector<double>> Ranks::ended_sum() {
  if (!job_) return std::exchange(alone_, {});
  if (job_->sum == MPI_REQUEST_NULL) return {};
  int done = 0;
  MPI_Test(&job_->sum, &done, MPI_STATUS_IGNORE);
  if (!done) return {};
  return job_->total;
}

void Ranks::together(const std::function<void()>& work) {
  std::exception_ptr failure;
  try {
    work();
  } catch (...) {
    failure = std::current_exception();
  }
  int mine = failure ? rank_ : count_, first = mine;
  if (job_) {
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Iallreduce(&mine, &first, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD, &request);
    patiently(request);
  }
  parted_ = parted_ || first < count_;
  if (first == rank_) std::rethrow_exception(failure);
  if (first < count_) throw Error("");
}

std::string Ranks::of_first(std::string text) {
  if (!job_) return text;
  text.resize(common_size(text.size()));
  broadcast_in_parts(text.size(), [&](std::size_t at, int number, MPI_Request* request) {
    MPI_Ibcast(text.data() + at, number, MPI_CHAR, 0, MPI_COMM_WORLD, request);
  });
  return text;
}

std::shared_ptr<const float[]> Ranks::once_per_node(std::span<const float> of_first) {
  if (!job_) {
    std::shared_ptr<float[]> own(new float[of_first.size()]);
    std::ranges::copy(of_first, own.get());
    return own;
  }
  const std::size_t size = common_size(of_first.size());
  Job::NodeMemory memory;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, rank_, MPI_INFO_NULL, &memory.node);
  int on_node = 0;
  MPI_Comm_rank(memory.node, &on_node);
  const std::size_t bytes = on_node == 0 ? size * sizeof(float) : 0;
  together([&] { require_shared_memory(bytes); });
  MPI_Win_allocate_shared(static_cast<MPI_Aint>(bytes), sizeof(float), MPI_INFO_NULL, memory.node, &memory.numbers,
                          &memory.window);
  MPI_Aint held = 0;
  int unit = 0;
  MPI_Win_shared_query(memory.window, 0, &held, &unit, &memory.numbers);
  if (rank_ == 0) std::ranges::copy(of_first, memory.numbers);
  MPI_Comm leaders = MPI_COMM_NULL;
  MPI_Comm_split(MPI_COMM_WORLD, on_node == 0 ? 0 : MPI_UNDEFINED, rank_, &leaders);
  if (leaders != MPI_COMM_NULL) {
    broadcast_in_parts(size, [&](std::size_t at, int number, MPI_Request* request) {
      MPI_Ibcast(memory.numbers + at, number, MPI_FLOAT, 0, leaders, request);
    });
    MPI_Comm_free(&leaders);
  }
  MPI_Win_fence(0, memory.window);
  job_->memories.push_back(memory);
  // The job frees it, together with the other ranks.
  return {memory.numbers, [](const float*) {}};
}

void Ranks::run(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::exception& error) {
    if (!parted_) abandon(error.what());
    throw;
  }
}

void Ranks::abandon(const std::string& why) {
  if (!job_) return;
  std::fputs(fmt::format("clog: rank {}: {}\n", rank_, why).c_str(), stderr);
  std::fflush(stderr);
  MPI_Abort(MPI_COMM_WORLD, 1);
}

void Ranks::wait(const std::function<void()>& meanwhile) {
  if (!job_) return;
  MPI_Request all = MPI_REQUEST_NULL;
  Nap nap(longest_idle);
  for (int done = 0; !done;) {
    serve();
    // A line is there when it was taken, so whoever has come here has none on its way.
    if (all == MPI_REQUEST_NULL && job_->letters.empty()) MPI_Ibarrier(MPI_COMM_WORLD, &all);
    if (all != MPI_REQUEST_NULL) MPI_Test(&all, &done, MPI_STATUS_IGNORE);
    if (meanwhile) meanwhile();
    if (!done) nap();
  }
}

}  // namespace clogflow
