// The memory of contacts: springs of many contacts, one array per component.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "dem/kernels.hpp"

namespace clog {

class SpringTable {
public:
  /// Forgets everything; `count` contacts, none of them touching.
  void reset(std::size_t count);

  std::size_t size() const { return touching_.size(); }
  bool touching(std::size_t slot) const { return touching_[slot] != 0; }
  Springs<double> get(std::size_t slot) const;

  /// Marks the contact as one of the last step, with these springs.
  void set(std::size_t slot, const Springs<double>& springs);

  SpringPointers pointers();

private:
  std::array<std::vector<double>, 7> component_;
  std::vector<std::uint8_t> touching_;
};

/// The same springs seen from the other particle: normal, sliding and rolling velocity change sign,
/// the component along the normal does not.
Springs<double> swapped(const Springs<double>& springs);

}  // namespace clog
