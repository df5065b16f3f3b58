// HDF5 files that explain themselves: a format name and version at the root, a unit on every
// dataset, and no file under its final name before it is whole.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "coupling/base/file_part.hpp"

namespace clogflow {

/// What kind of file it is; a reader refuses any other name or version.
struct FileFormat {
  std::string name;  ///< "clogflow flow"
  int version = 0;
};

/// How a dataset is stored.
struct DatasetLayout {
  std::string unit;                ///< SI, as si_unit writes it; "1" for numbers
  std::vector<std::size_t> shape;  ///< slowest index first; empty: as long as the values
};

/// Owns one identifier of the HDF5 library.
class Hdf5Handle {
public:
  using Close = int (*)(std::int64_t);
  Hdf5Handle() = default;
  Hdf5Handle(std::int64_t id, Close close) : id_(id), close_(close) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept { *this = std::move(other); }
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Hdf5Handle() { reset(); }

  std::int64_t id() const { return id_; }
  bool valid() const { return id_ >= 0; }
  /// \return false if closing failed, as on a full disk
  bool reset() {
    const std::int64_t id = std::exchange(id_, -1);
    return id < 0 || close_(id) >= 0;
  }

private:
  std::int64_t id_ = -1;
  Close close_ = nullptr;
};

/// Writes into a FilePart; finish() gives it its name. Without finish() nothing remains.
/// Every member throws Error naming the file and the dataset.
class Hdf5Writer {
public:
  Hdf5Writer(const std::filesystem::path& file, const FileFormat& format);

  /// T: double, float, std::int64_t, std::uint64_t, std::uint8_t. Groups on the way are created.
  template <class T>
  void write(const std::string& dataset, const std::vector<T>& values, const DatasetLayout& layout);
  void write_text(const std::string& dataset, const std::string& text);

  /// T: double, std::int64_t
  template <class T>
  void attribute(const std::string& object, const std::string& name, const std::vector<T>& values);
  void attribute(const std::string& object, const std::string& name, const std::string& text);
  void group(const std::string& path);
  /// For coupling/files alone: the root, and what is said where something could not be written into it.
  const Hdf5Handle& root() const { return handle_; }
  void require_written(bool done, const std::string& path) const;

  /// Flushes to the disk, then gives it its name.
  void finish();

private:
  std::filesystem::path file_;
  FilePart part_;  // outlives the handle, so that the library has closed what is removed
  Hdf5Handle handle_;
};

template <class T>
struct Hdf5Array {
  std::vector<T> values;
  std::vector<std::size_t> shape;  ///< slowest index first
};

/// A pack (files/run_pack.hpp) is read as if it were a folder: "pack.h5/run_0007.h5" is the file run_0007.h5 in it.
/// Every member throws Error naming the file, the dataset and what is wrong with it.
class Hdf5Reader {
public:
  Hdf5Reader(const std::filesystem::path& file, const FileFormat& format);

  bool has(const std::string& path) const;
  /// Numbers of the same class (integer or floating) as T, with exactly this unit.
  template <class T>
  Hdf5Array<T> read(const std::string& dataset, const std::string& unit) const;
  std::string read_text(const std::string& dataset) const;
  std::string text_attribute(const std::string& object, const std::string& name) const;
  std::vector<double> number_attribute(const std::string& object, const std::string& name) const;

  /// For coupling/files alone.
  const Hdf5Handle& root() const { return handle_; }

  /// For checks of the caller: throws Error("<file>: <message>") unless the condition holds.
  void check(bool condition, const std::string& message) const;

private:
  const Hdf5Handle* open_group(const std::string& path) const;
  const Hdf5Handle* holder_of(const std::string& path) const;
  Hdf5Handle open_object(const std::string& object) const;
  Hdf5Handle open_dataset(const std::string& dataset) const;
  void spend(double bytes) const;

  std::filesystem::path file_;
  Hdf5Handle handle_;                                 ///< the root, of the file or of one run in a pack
  mutable std::map<std::string, Hdf5Handle> groups_;  ///< opened so far: many datasets lie in one
  double size_;                                       ///< of the file [byte]
  mutable double unpacked_ = 0;                       ///< by all reads so far [byte]
};

/// Format name and version of any file that Hdf5Writer wrote, or of one in a pack.
/// \throws Error if it is no HDF5 file, truncated, or not one of ours
FileFormat file_format(const std::filesystem::path& file);

}  // namespace clogflow
