// Records of four doubles as vectors, one component each, and back; in registers, for a vector that two halves were
// stored to is not there yet when it is loaded as a whole.
#pragma once

#include "dem/kernels/lanes.hpp"

namespace clogflow {
namespace {

/// One component of many records as vectors.
struct Columns {
  Lanes c[4];
};

/// Four doubles: one packed record.
typedef double RawQuad __attribute__((vector_size(32)));

/// As it lies in memory, aligned as a double is; see LanesInMemory.
typedef double QuadInMemory __attribute__((vector_size(32), aligned(8)));

/// The records of a vector in as few registers as hold them.
#if defined(__AVX512F__)
typedef double RawOct __attribute__((vector_size(64)));

/// Eight records, two in a vector: 0 and 2, 1 and 3, 4 and 6, 5 and 7. In this order half as many shuffles do as for
/// two times four records.
struct Rows {
  RawOct pair[4];

  static constexpr int first[4] = {0, 1, 4, 5}, second[4] = {2, 3, 6, 7};

  /// \param quad  gives record k
  template <class Quad>
  [[gnu::always_inline]] static Rows of(const Quad& quad) {
    Rows rows;
    for (int v = 0; v < 4; ++v)
      rows.pair[v] = __builtin_shufflevector(quad(first[v]), quad(second[v]), 0, 1, 2, 3, 4, 5, 6, 7);
    return rows;
  }

  [[gnu::always_inline]] RawQuad operator[](int k) const {
    const RawOct& both = pair[(k & 1) + 2 * (k >> 2)];
    return k & 2 ? __builtin_shufflevector(both, both, 4, 5, 6, 7) : __builtin_shufflevector(both, both, 0, 1, 2, 3);
  }
};

[[gnu::always_inline]] inline Rows operator-(const Rows& a, const Rows& b) {
  return {{a.pair[0] - b.pair[0], a.pair[1] - b.pair[1], a.pair[2] - b.pair[2], a.pair[3] - b.pair[3]}};
}

[[gnu::always_inline]] inline Columns to_columns(const Rows& rows) {
  const auto even = [](RawOct a, RawOct b) { return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14); };
  const auto odd = [](RawOct a, RawOct b) { return __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15); };
  const auto front = [](RawOct a, RawOct b) { return Lanes(__builtin_shufflevector(a, b, 0, 1, 4, 5, 8, 9, 12, 13)); };
  const auto back = [](RawOct a, RawOct b) { return Lanes(__builtin_shufflevector(a, b, 2, 3, 6, 7, 10, 11, 14, 15)); };
  const RawOct even_0 = even(rows.pair[0], rows.pair[1]), even_1 = even(rows.pair[2], rows.pair[3]);
  const RawOct odd_0 = odd(rows.pair[0], rows.pair[1]), odd_1 = odd(rows.pair[2], rows.pair[3]);
  return {{front(even_0, even_1), front(odd_0, odd_1), back(even_0, even_1), back(odd_0, odd_1)}};
}

[[gnu::always_inline]] inline Rows to_rows(const Lanes& x, const Lanes& y, const Lanes& z, const Lanes& w) {
  const auto raw = [](const Lanes& v) { return static_cast<RawOct>(v); };
  const auto even = [](RawOct a, RawOct b) { return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14); };
  const auto odd = [](RawOct a, RawOct b) { return __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15); };
  const auto front = [](RawOct a, RawOct b) { return __builtin_shufflevector(a, b, 0, 1, 8, 9, 2, 3, 10, 11); };
  const auto back = [](RawOct a, RawOct b) { return __builtin_shufflevector(a, b, 4, 5, 12, 13, 6, 7, 14, 15); };
  const RawOct even_xy = even(raw(x), raw(y)), even_zw = even(raw(z), raw(w));
  const RawOct odd_xy = odd(raw(x), raw(y)), odd_zw = odd(raw(z), raw(w));
  return {{front(even_xy, even_zw), front(odd_xy, odd_zw), back(even_xy, even_zw), back(odd_xy, odd_zw)}};
}
#elif defined(__AVX__)
struct Rows {
  RawQuad quad[4];

  template <class Quad>
  [[gnu::always_inline]] static Rows of(const Quad& quad) {
    return {{quad(0), quad(1), quad(2), quad(3)}};
  }

  [[gnu::always_inline]] RawQuad operator[](int k) const { return quad[k]; }
};

[[gnu::always_inline]] inline Rows operator-(const Rows& a, const Rows& b) {
  return {{a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]}};
}

/// Rows to columns; its own inverse.
[[gnu::always_inline]] inline Rows transpose(const RawQuad& a, const RawQuad& b, const RawQuad& c, const RawQuad& d) {
  const RawQuad low_ab = __builtin_shufflevector(a, b, 0, 4, 2, 6), high_ab = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const RawQuad low_cd = __builtin_shufflevector(c, d, 0, 4, 2, 6), high_cd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return {{__builtin_shufflevector(low_ab, low_cd, 0, 1, 4, 5), __builtin_shufflevector(high_ab, high_cd, 0, 1, 4, 5),
           __builtin_shufflevector(low_ab, low_cd, 2, 3, 6, 7), __builtin_shufflevector(high_ab, high_cd, 2, 3, 6, 7)}};
}

[[gnu::always_inline]] inline Columns to_columns(const Rows& rows) {
  const Rows c = transpose(rows[0], rows[1], rows[2], rows[3]);
  return {{Lanes(c[0]), Lanes(c[1]), Lanes(c[2]), Lanes(c[3])}};
}

[[gnu::always_inline]] inline Rows to_rows(const Lanes& x, const Lanes& y, const Lanes& z, const Lanes& w) {
  const auto raw = [](const Lanes& v) { return static_cast<RawQuad>(v); };
  return transpose(raw(x), raw(y), raw(z), raw(w));
}
#endif

}  // namespace
}  // namespace clogflow
