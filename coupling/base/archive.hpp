// Any state as bytes and back, bit by bit: what a checkpoint is made of.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "coupling/base/require.hpp"
#include "coupling/base/vector.hpp"

namespace clogflow {

/// A class takes part through one member function, the same for both directions:
///   `template <class Archive> void exchange(Archive& archive) { archive(a_, b_, c_); }`
class ArchiveWriter {
public:
  static constexpr bool loading = false;

  template <class... Values>
  void operator()(Values&... values) {
    (put(values), ...);
  }

  const std::string& bytes() const { return bytes_; }

private:
  void raw(const void* from, std::size_t size) { bytes_.append(static_cast<const char*>(from), size); }

  template <class T>
  void put(T& value) {
    if constexpr (requires { value.exchange(*this); }) {
      value.exchange(*this);
    } else {
      static_assert(std::is_trivially_copyable_v<T>);
      raw(&value, sizeof value);
    }
  }
  void put(Vec3& value) { raw(&value, sizeof value); }
  void put(std::string& text) {
    std::size_t size = text.size();
    put(size);
    raw(text.data(), size);
  }
  template <class T>
  void put(std::vector<T>& values) {
    std::size_t size = values.size();
    put(size);
    if constexpr (std::is_trivially_copyable_v<T> && !std::is_same_v<T, Vec3>) {
      raw(values.data(), size * sizeof(T));
    } else {
      for (T& value : values) put(value);
    }
  }

  std::string bytes_;
};

/// Reads what ArchiveWriter wrote, in the same order. \throws Error if the bytes end too early
class ArchiveReader {
public:
  static constexpr bool loading = true;

  explicit ArchiveReader(std::string bytes) : bytes_(std::move(bytes)) {}

  template <class... Values>
  void operator()(Values&... values) {
    (take(values), ...);
  }

  bool at_end() const { return position_ == bytes_.size(); }

private:
  void raw(void* to, std::size_t size) {
    require(size <= bytes_.size() - position_, "a saved state ends too early");
    if (size > 0) std::memcpy(to, bytes_.data() + position_, size);
    position_ += size;
  }

  template <class T>
  void take(T& value) {
    if constexpr (requires { value.exchange(*this); }) {
      value.exchange(*this);
    } else {
      static_assert(std::is_trivially_copyable_v<T>);
      raw(&value, sizeof value);
    }
  }
  /// A bool with another value than these two would be undefined behaviour later.
  void take(bool& value) {
    std::uint8_t byte = 0;
    raw(&byte, 1);
    require(byte <= 1, "a saved state is damaged");
    value = byte == 1;
  }
  void take(Vec3& value) { raw(&value, sizeof value); }
  void take(std::string& text) {
    text.resize(take_size(1));
    raw(text.data(), text.size());
  }
  template <class T>
  void take(std::vector<T>& values) {
    if constexpr (std::is_trivially_copyable_v<T> && !std::is_same_v<T, Vec3>) {
      values.resize(take_size(sizeof(T)));
      raw(values.data(), values.size() * sizeof(T));
    } else {
      values.resize(take_size(1));
      for (T& value : values) take(value);
    }
  }

  /// A count whose values must still fit into the bytes, so that a bad file cannot ask for all memory.
  std::size_t take_size(std::size_t each) {
    std::size_t size = 0;
    take(size);
    require(size <= (bytes_.size() - position_) / each, "a saved state ends too early");
    return size;
  }

  std::string bytes_;
  std::size_t position_ = 0;
};

}  // namespace clogflow
