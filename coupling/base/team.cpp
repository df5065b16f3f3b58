#include "coupling/base/team.hpp"

namespace clogflow {

namespace {

/// Looks before a thread sleeps: some microseconds, as long as the pause between two loops of a step.
constexpr int patience = 4000;

template <class Value>
void wait_while(const std::atomic<Value>& value, Value old) {
  for (int k = 0; k < patience; ++k) {
    if (value.load(std::memory_order_acquire) != old) return;
    __builtin_ia32_pause();
  }
  value.wait(old, std::memory_order_acquire);
}

}  // namespace

Team::Team(int threads) {
  for (int k = 1; k < threads; ++k) others_.emplace_back([this] { help(); });
}

Team::~Team() {
  over_ = true;
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  for (std::thread& other : others_) other.join();
}

void Team::share(int count, Call call, const void* work) {
  count_ = count, call_ = call, work_ = work;
  failed_ = false;
  next_ = 0;
  busy_ = static_cast<int>(others_.size());
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  take_tasks();
  for (int left = busy_.load(std::memory_order_acquire); left > 0; left = busy_.load(std::memory_order_acquire))
    wait_while(busy_, left);
  if (failed_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void Team::help() {
  for (unsigned seen = 0;; ++seen) {
    wait_while(round_, seen);
    if (over_) return;
    take_tasks();
    if (busy_.fetch_sub(1, std::memory_order_acq_rel) == 1) busy_.notify_one();
  }
}

void Team::take_tasks() noexcept {
  for (int k = next_.fetch_add(1); k < count_; k = next_.fetch_add(1)) {
    try {
      call_(work_, k);
    } catch (...) {
      if (!failed_.exchange(true)) failure_ = std::current_exception();
    }
  }
}

}  // namespace clogflow
