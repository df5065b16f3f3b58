// FNV-1a, 64 bits.
#include "coupling/base/content_hash.hpp"

#include <cstdint>

#include <fmt/format.h>

namespace clogflow {

std::string content_hash(const std::string& text) {
  constexpr std::uint64_t offset_basis = 0xcbf29ce484222325;
  constexpr std::uint64_t prime = 0x100000001b3;
  std::uint64_t hash = offset_basis;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * prime;
  return fmt::format("{:016x}", hash);
}

}  // namespace clogflow
