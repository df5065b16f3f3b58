// Signals that ask the program to stop: what is under way saves its state and ends.
#pragma once

#include <atomic>
#include <csignal>
#include <initializer_list>

namespace clogflow::cli {

/// A lock-free atomic is all that a signal handler may touch.
inline std::atomic<bool> stop_asked = false;
inline std::atomic<int> stop_signal = 0;  ///< the last that asked; 0: none

/// From now on, each of these signals asks.
inline void stop_at(std::initializer_list<int> signals) {
  for (const int signal : signals) std::signal(signal, [](int number) { stop_signal = number, stop_asked = true; });
}

}  // namespace clogflow::cli
