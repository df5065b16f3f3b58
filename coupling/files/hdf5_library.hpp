// The HDF5 C library behind handles; for hdf5_writer.cpp and hdf5_reader.cpp only.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <type_traits>

#include "coupling/files/hdf5_file.hpp"

namespace clogflow {

static_assert(std::is_same_v<hid_t, std::int64_t>, "Hdf5Handle stores identifiers as 64-bit integers");

/// The library prints its own error stack by default; our messages replace it. Its clean-up at exit
/// is off too: handles close everything, and after a close that failed on a full disk it crashes.
inline void silence_hdf5() {
  static const bool kept_after_exit = H5dont_atexit() >= 0;
  static_cast<void>(kept_after_exit);
  H5open();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

template <herr_t (*close)(hid_t)>
Hdf5Handle hdf5_handle(hid_t id) {
  return {id, [](std::int64_t other) -> int { return close(other); }};
}

inline Hdf5Handle file_handle(hid_t id) { return hdf5_handle<H5Fclose>(id); }
inline Hdf5Handle group_handle(hid_t id) { return hdf5_handle<H5Gclose>(id); }
inline Hdf5Handle dataset_handle(hid_t id) { return hdf5_handle<H5Dclose>(id); }
inline Hdf5Handle object_handle(hid_t id) { return hdf5_handle<H5Oclose>(id); }
inline Hdf5Handle space_handle(hid_t id) { return hdf5_handle<H5Sclose>(id); }
inline Hdf5Handle type_handle(hid_t id) { return hdf5_handle<H5Tclose>(id); }
inline Hdf5Handle attribute_handle(hid_t id) { return hdf5_handle<H5Aclose>(id); }
inline Hdf5Handle list_handle(hid_t id) { return hdf5_handle<H5Pclose>(id); }

template <class T>
hid_t memory_type() {
  if constexpr (std::is_same_v<T, double>) return H5T_NATIVE_DOUBLE;
  if constexpr (std::is_same_v<T, float>) return H5T_NATIVE_FLOAT;
  if constexpr (std::is_same_v<T, std::int64_t>) return H5T_NATIVE_INT64;
  if constexpr (std::is_same_v<T, std::uint64_t>) return H5T_NATIVE_UINT64;
  if constexpr (std::is_same_v<T, std::uint8_t>) return H5T_NATIVE_UINT8;
}

/// On disk always little-endian, so that a file is the same on every machine.
template <class T>
hid_t disk_type() {
  if constexpr (std::is_same_v<T, double>) return H5T_IEEE_F64LE;
  if constexpr (std::is_same_v<T, float>) return H5T_IEEE_F32LE;
  if constexpr (std::is_same_v<T, std::int64_t>) return H5T_STD_I64LE;
  if constexpr (std::is_same_v<T, std::uint64_t>) return H5T_STD_U64LE;
  if constexpr (std::is_same_v<T, std::uint8_t>) return H5T_STD_U8LE;
}

}  // namespace clogflow
