// Work on all cores for a library that is not safe for threads (HDF5 of Debian): processes instead.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace clogflow {

/// Cores that this process may use.
std::size_t usable_cores();

/// Calls take(i, work(i)) for i = 0 ... count - 1, in that order, here. The work is done by forked processes, worker w
/// of them doing i = w, w + workers, ...; each waits when it is a few results ahead, so that memory stays bounded. One
/// worker is this process itself. Call it where no other thread runs.
/// \param work  bytes of a result; must not throw: what goes wrong is part of the result
/// \throws Error when no process can be begun, or one ends early (killed, out of memory); and what take throws. No
///         process is left behind
void in_processes(std::size_t count, std::size_t workers, const std::function<std::string(std::size_t)>& work,
                  const std::function<void(std::size_t, std::string)>& take);

}  // namespace clogflow
