// Vectors of doubles and how they get to and from the particles. Everything in this folder's
// headers is compiled once per instruction set, under flags that no other file has; it must
// therefore use nothing that another file could also instantiate (no containers).
#pragma once

#include "dem/kernels/kernels.hpp"

namespace clogflow {
namespace {

using Lanes = stdx::native_simd<double>;
constexpr int lanes = static_cast<int>(Lanes::size());
using Index = const int*;

/// Four doubles: one packed record.
using Quad = stdx::simd<double, stdx::simd_abi::deduce_t<double, 4>>;
typedef double RawQuad __attribute__((vector_size(32)));

/// Vectors in memory, aligned as a double is. Read and written through these types and not as
/// bytes: bytes could be anybody's, so that after each store the compiler would have to read all
/// indices anew.
typedef double QuadInMemory __attribute__((vector_size(32), aligned(8)));
typedef double LanesInMemory __attribute__((vector_size(8 * lanes), aligned(8)));

[[gnu::always_inline]] inline Lanes load_lanes(const double* values) {
  return Lanes(*reinterpret_cast<const LanesInMemory*>(values));
}

[[gnu::always_inline]] inline void store_lanes(double* values, const Lanes& amount) {
  *reinterpret_cast<LanesInMemory*>(values) = static_cast<LanesInMemory>(amount);
}

/// One component of many records as vectors.
struct Columns {
  Lanes c[4];
};

[[gnu::always_inline]] inline Lanes load(const double* values, Index at) {
  return Lanes([&](auto k) { return values[at[k]]; });
}

#ifdef __AVX__
[[gnu::always_inline]] inline RawQuad load_quad(const double* record) {
  return *reinterpret_cast<const QuadInMemory*>(record);
}

/// A vector from its quads, and back; in registers, for a vector that two halves were stored to is not there yet when
/// it is loaded as a whole. Templates, so that only the branch that fits is compiled.
template <class V>
[[gnu::always_inline]] inline V join(const RawQuad* quads) {
  if constexpr (V::size() == 4) {
    return V(quads[0]);
  } else {
    return V(__builtin_shufflevector(quads[0], quads[1], 0, 1, 2, 3, 4, 5, 6, 7));
  }
}

template <int half, class V>
[[gnu::always_inline]] inline RawQuad part(const V& v) {
  if constexpr (V::size() == 4) {
    return static_cast<RawQuad>(v);
  } else {
    const auto raw = static_cast<LanesInMemory>(v);
    return __builtin_shufflevector(raw, raw, 4 * half, 4 * half + 1, 4 * half + 2, 4 * half + 3);
  }
}

/// Rows to columns; its own inverse.
[[gnu::always_inline]] inline void transpose(RawQuad (&q)[4]) {
  const RawQuad low_01 = __builtin_shufflevector(q[0], q[1], 0, 4, 2, 6);
  const RawQuad high_01 = __builtin_shufflevector(q[0], q[1], 1, 5, 3, 7);
  const RawQuad low_23 = __builtin_shufflevector(q[2], q[3], 0, 4, 2, 6);
  const RawQuad high_23 = __builtin_shufflevector(q[2], q[3], 1, 5, 3, 7);
  q[0] = __builtin_shufflevector(low_01, low_23, 0, 1, 4, 5);
  q[1] = __builtin_shufflevector(high_01, high_23, 0, 1, 4, 5);
  q[2] = __builtin_shufflevector(low_01, low_23, 2, 3, 6, 7);
  q[3] = __builtin_shufflevector(high_01, high_23, 2, 3, 6, 7);
}
#endif

/// Reads record `at[k]` of each lane k; a record is four doubles, `stride` doubles from the next.
[[gnu::always_inline]] inline Columns load_records(const double* base, int stride, Index at) {
  Columns columns;
#ifdef __AVX__
  RawQuad quads[lanes / 4][4];
  for (int half = 0; half < lanes / 4; ++half) {
    for (int k = 0; k < 4; ++k) quads[half][k] = load_quad(base + stride * at[4 * half + k]);
    transpose(quads[half]);
  }
  for (int c = 0; c < 4; ++c) {
    RawQuad column[lanes / 4];
    for (int half = 0; half < lanes / 4; ++half) column[half] = quads[half][c];
    columns.c[c] = join<Lanes>(column);
  }
#else
  for (int c = 0; c < 4; ++c) columns.c[c] = Lanes([&](auto k) { return base[stride * at[k] + c]; });
#endif
  return columns;
}

/// Records of i less those of j, lane by lane: subtracted before they are transposed, which is once
/// instead of twice.
[[gnu::always_inline]] inline Columns load_differences(const double* base, int stride, Index i, Index j) {
#ifdef __AVX__
  Columns columns;
  RawQuad quads[lanes / 4][4];
  for (int half = 0; half < lanes / 4; ++half) {
    for (int k = 0; k < 4; ++k)
      quads[half][k] = load_quad(base + stride * i[4 * half + k]) - load_quad(base + stride * j[4 * half + k]);
    transpose(quads[half]);
  }
  for (int c = 0; c < 4; ++c) {
    RawQuad column[lanes / 4];
    for (int half = 0; half < lanes / 4; ++half) column[half] = quads[half][c];
    columns.c[c] = join<Lanes>(column);
  }
  return columns;
#else
  Columns a = load_records(base, stride, i);
  const Columns b = load_records(base, stride, j);
  for (int c = 0; c < 4; ++c) a.c[c] -= b.c[c];
  return a;
#endif
}

/// Rows of a 3-vector, ready to be added to records or to become some.
struct Records {
#ifdef __AVX__
  RawQuad rows[lanes];

  explicit Records(const Vector<Lanes>& v, const Lanes& w = Lanes(0.0)) {
    put<0>(v, w);
    if constexpr (lanes == 8) put<lanes / 4 - 1>(v, w);
  }

  template <int half>
  [[gnu::always_inline]] void put(const Vector<Lanes>& v, const Lanes& w) {
    RawQuad quads[4] = {part<half>(v.x), part<half>(v.y), part<half>(v.z), part<half>(w)};
    transpose(quads);
    for (int k = 0; k < 4; ++k) rows[4 * half + k] = quads[k];
  }
#else
  double rows[lanes][4];

  explicit Records(const Vector<Lanes>& v, const Lanes& w = Lanes(0.0)) {
    for (int k = 0; k < lanes; ++k) rows[k][0] = v.x[k], rows[k][1] = v.y[k], rows[k][2] = v.z[k], rows[k][3] = w[k];
  }
#endif

  /// Row k becomes record k, for the first `used` lanes.
  [[gnu::always_inline]] void store(double* base, int stride, int used) const {
    const auto put = [&](int k) {
#ifdef __AVX__
      *reinterpret_cast<QuadInMemory*>(base + stride * k) = rows[k];
#else
      for (int c = 0; c < 4; ++c) base[stride * k + c] = rows[k][c];
#endif
    };
    if (used == lanes) {
#pragma GCC unroll 8
      for (int k = 0; k < lanes; ++k) put(k);
    } else {
      for (int k = 0; k < used; ++k) put(k);
    }
  }

  /// Adds (sign 1) or subtracts (sign -1) row k to the record, one row after the other: two lanes
  /// may name the same record.
  template <int sign>
  void apply(double* record, int k) const {
#ifdef __AVX__
    const RawQuad before = load_quad(record);
    *reinterpret_cast<QuadInMemory*>(record) = sign > 0 ? before + rows[k] : before - rows[k];
#else
    for (int c = 0; c < 3; ++c) record[c] += sign * rows[k][c];
#endif
  }

  /// The same for the first `used` lanes; almost every vector is full.
  template <int sign>
  void apply(double* base, Index at, int used) const {
    if (used == lanes) {
      for (int k = 0; k < lanes; ++k) apply<sign>(base + record_stride * at[k], k);
    } else {
      for (int k = 0; k < used; ++k) apply<sign>(base + record_stride * at[k], k);
    }
  }
};

/// So few particles stay in the second cache from step to step, and asking would only cost.
constexpr std::size_t stay_near = 2000;

/// Starts to bring the first so many doubles of particles near.
[[gnu::always_inline]] inline void prefetch(const ParticlePointers& p, Index at, int parts = record_stride) {
  if (p.count <= stay_near) return;
  constexpr int line = 64 / sizeof(double);
  for (int k = 0; k < lanes; ++k)
    for (int part = 0; part < parts; part += line) __builtin_prefetch(p.state + record_stride * at[k] + part, 1);
}

/// Row `row` of particles one after the other; beyond `used` the last one again.
[[gnu::always_inline]] inline Columns load_row(const ParticlePointers& p, int row, std::size_t from, int used) {
  int at[lanes];
  for (int k = 0; k < lanes; ++k) at[k] = k < used ? k : used - 1;
  return load_records(p.state + record_stride * from + row, record_stride, at);
}

/// Position and radius, velocity and mass, or spin of the particles in each lane.
struct Placed {
  Vector<Lanes> position;
  Lanes radius;
};

[[gnu::always_inline]] inline Placed load_place(const ParticlePointers& p, Index at) {
  const Columns c = load_records(p.state, record_stride, at);
  return {{c.c[0], c.c[1], c.c[2]}, c.c[3]};
}

struct Moving {
  Vector<Lanes> velocity;
  Lanes mass;
};

[[gnu::always_inline]] inline Moving load_motion(const ParticlePointers& p, Index at) {
  const Columns c = load_records(p.state + 4, record_stride, at);
  return {{c.c[0], c.c[1], c.c[2]}, c.c[3]};
}

[[gnu::always_inline]] inline Vector<Lanes> load_spin(const ParticlePointers& p, Index at) {
  const Columns c = load_records(p.state + 8, record_stride, at);
  return {c.c[0], c.c[1], c.c[2]};
}

[[gnu::always_inline]] inline void add_force(const ParticlePointers& p, Index at, const Vector<Lanes>& force,
                                             int used) {
  Records(force).apply<1>(p.loads, at, used);
}

/// Newton's third law: i gets the force, j its opposite.
[[gnu::always_inline]] inline void add_force(const ParticlePointers& p, Index i, Index j, const Vector<Lanes>& force,
                                             int used) {
  const Records records(force);
  records.apply<1>(p.loads, i, used);
  records.apply<-1>(p.loads, j, used);
}

[[gnu::always_inline]] inline void add_torque(const ParticlePointers& p, Index at, const Vector<Lanes>& torque,
                                              int used) {
  Records(torque).apply<1>(p.loads + 4, at, used);
}

[[gnu::always_inline]] inline int lanes_left(std::size_t from, std::size_t count) {
  const std::size_t left = count - from;
  return left < static_cast<std::size_t>(lanes) ? static_cast<int>(left) : lanes;
}

/// Zero in the spare lanes, whose indices are padding.
[[gnu::always_inline]] inline Lanes used_lanes(const Lanes& values, int used) {
  if (used == lanes) return values;
  return Lanes([&](auto k) { return static_cast<int>(k) < used ? values[k] : 0.0; });
}

/// Reads or writes a stretch of an array that may end before the vector does.
[[gnu::always_inline]] inline Lanes load_part(const double* values, int used) {
  if (used == lanes) return load_lanes(values);
  return Lanes([&](auto k) {
    const int lane = static_cast<int>(k);
    return values[lane < used ? lane : used - 1];
  });
}

[[gnu::always_inline]] inline void store_part(double* values, Lanes amount, int used) {
  if (used == lanes) {
    store_lanes(values, amount);
  } else {
    for (int k = 0; k < used; ++k) values[k] = amount[k];
  }
}

}  // namespace
}  // namespace clogflow
