// How vectors get to the particles and back.
#pragma once

#include "dem/kernels/rows.hpp"

namespace clogflow {
namespace {

#ifdef __AVX__
[[gnu::always_inline]] inline RawQuad load_quad(const double* record) {
  return *reinterpret_cast<const QuadInMemory*>(record);
}

[[gnu::always_inline]] inline Rows load_rows(const double* base, int stride, Index at) {
  return Rows::of([&](int k) { return load_quad(base + stride * at[k]); });
}
#endif

/// Reads record `at[k]` of each lane k; a record is four doubles, `stride` doubles from the next.
[[gnu::always_inline]] inline Columns load_records(const double* base, int stride, Index at) {
#ifdef __AVX__
  return to_columns(load_rows(base, stride, at));
#else
  Columns columns;
  for (int c = 0; c < 4; ++c) columns.c[c] = Lanes([&](auto k) { return base[stride * at[k] + c]; });
  return columns;
#endif
}

/// Records of i less those of j, lane by lane: subtracted before they are transposed, which is once
/// instead of twice.
[[gnu::always_inline]] inline Columns load_differences(const double* base, int stride, Index i, Index j) {
#ifdef __AVX__
  return to_columns(load_rows(base, stride, i) - load_rows(base, stride, j));
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
  Rows rows;

  [[gnu::always_inline]] explicit Records(const Vector<Lanes>& v, const Lanes& w = Lanes(0.0))
      : rows(to_rows(v.x, v.y, v.z, w)) {}
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
    for_lanes(used, put);
  }

  /// Adds (sign 1) or subtracts (sign -1) row k to the record, one row after the other: two lanes
  /// may name the same record.
  template <int sign>
  [[gnu::always_inline]] void apply(double* record, int k) const {
#ifdef __AVX__
    const RawQuad before = load_quad(record);
    *reinterpret_cast<QuadInMemory*>(record) = sign > 0 ? before + rows[k] : before - rows[k];
#else
    for (int c = 0; c < 3; ++c) record[c] += sign * rows[k][c];
#endif
  }

  /// The same for the first `used` lanes; almost every vector is full.
  template <int sign>
  [[gnu::always_inline]] void apply(double* base, Index at, int used) const {
    for_lanes(used, [&](int k) { apply<sign>(base + record_stride * at[k], k); });
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

}  // namespace
}  // namespace clogflow
