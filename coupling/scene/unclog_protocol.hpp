// What the words of unclog.protocol have in common.
#pragma once

#include "coupling/scene/scene.hpp"

namespace clogflow {

/// Whether a run goes on after its clogs because the protocol ends them: it then has many bursts, every one but the
/// first made by the protocol, and a table of releases.
constexpr bool clears_clogs(UnclogProtocol protocol) {
  return protocol != UnclogProtocol::none && protocol != UnclogProtocol::stop;
}

/// Whether the column flows without friction after a clog until `unclog.strain` has passed.
constexpr bool restarts(UnclogProtocol protocol) {
  return protocol == UnclogProtocol::restart || protocol == UnclogProtocol::rewind;
}

}  // namespace clogflow
