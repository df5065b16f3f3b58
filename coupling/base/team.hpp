// Threads that share the work of one run.
#pragma once

#include <atomic>
#include <exception>
#include <thread>
#include <utility>
#include <vector>

namespace clogflow {

/// Tasks are handed out one by one, so the order in which they are done is not known: they must not touch the same
/// data. A team of one does them in order, in the caller.
class Team {
public:
  explicit Team(int threads = 1);
  ~Team();
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  int size() const { return static_cast<int>(others_.size()) + 1; }

  /// Calls work(k) once for each k from 0 to count - 1, and returns when all are done. What a call throws comes out
  /// here; of several the first.
  template <class Work>
  void each(int count, const Work& work) {
    if (size() == 1 || count < 2) {
      for (int k = 0; k < count; ++k) work(k);
    } else {
      share(
          count, [](const void* given, int k) { (*static_cast<const Work*>(given))(k); }, &work);
    }
  }

private:
  using Call = void (*)(const void*, int);

  void share(int count, Call call, const void* work);
  void help();
  void take_tasks() noexcept;

  std::vector<std::thread> others_;
  std::atomic<unsigned> round_ = 0;  // changes when there is work
  std::atomic<int> next_ = 0, busy_ = 0;
  std::atomic<bool> over_ = false;
  int count_ = 0;
  Call call_ = nullptr;
  const void* work_ = nullptr;
  std::exception_ptr failure_;
  std::atomic<bool> failed_ = false;
};

}  // namespace clogflow
