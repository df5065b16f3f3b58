// Writing: checksummed metadata and data, compressed where it pays, renamed only when whole.
#include <algorithm>
#include <numeric>
#include <string_view>

#include "coupling/base/require.hpp"
#include "coupling/files/hdf5_library.hpp"

namespace clogflow {
namespace {

std::size_t product(const std::vector<std::size_t>& shape) {
  return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>{});
}

// Large datasets are split along their slowest index; each piece has a checksum of its own.
Hdf5Handle creation_list(const std::vector<std::size_t>& shape, std::size_t bytes) {
  constexpr std::size_t smallest_chunked = 1 << 16;  // below, compression saves less than it costs
  constexpr std::size_t chunk_bytes = 1 << 20;
  Hdf5Handle list = list_handle(H5Pcreate(H5P_DATASET_CREATE));
  H5Pset_obj_track_times(list.id(), false);  // the same data make the same file
  if (bytes < smallest_chunked) return list;
  std::vector<hsize_t> chunk(shape.begin(), shape.end());
  const std::size_t row_bytes = std::max<std::size_t>(1, bytes / shape[0]);
  chunk[0] = std::clamp<std::size_t>(chunk_bytes / row_bytes, 1, shape[0]);
  H5Pset_chunk(list.id(), static_cast<int>(chunk.size()), chunk.data());
  H5Pset_shuffle(list.id());
  H5Pset_deflate(list.id(), 1);
  H5Pset_fletcher32(list.id());
  return list;
}

Hdf5Handle with_groups() {
  Hdf5Handle list = list_handle(H5Pcreate(H5P_LINK_CREATE));
  H5Pset_create_intermediate_group(list.id(), 1);
  return list;
}

// Fixed length, because VTK's reader does not take variable-length text.
Hdf5Handle text_type(const std::string& text) {
  Hdf5Handle type = type_handle(H5Tcopy(H5T_C_S1));
  H5Tset_size(type.id(), std::max<std::size_t>(1, text.size()));
  H5Tset_strpad(type.id(), H5T_STR_NULLPAD);
  const bool ascii = std::ranges::all_of(text, [](unsigned char c) { return c < 128; });
  H5Tset_cset(type.id(), ascii ? H5T_CSET_ASCII : H5T_CSET_UTF8);
  return type;
}

herr_t take_system_message(unsigned, const H5E_error2_t* error, void* found) {
  constexpr std::string_view label = "error message = '";
  const std::string_view text = error->desc == nullptr ? "" : error->desc;
  const auto at = text.find(label);
  if (at == text.npos) return 0;
  const auto rest = text.substr(at + label.size());
  *static_cast<std::string*>(found) = rest.substr(0, rest.find('\''));
  return 1;
}

/// Why the call that has just failed did: the library quotes the system in the lowest of its
/// messages.
std::string system_reason() {
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take_system_message, &reason);
  return reason.empty() ? "disk full?" : reason;
}

std::string padded(const std::string& text) { return text.empty() ? std::string(1, '\0') : text; }

}  // namespace

#if defined(__SANITIZE_ADDRESS__)
// What the library keeps until the end of the program is no leak of ours.
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5"; }
#endif

Hdf5Writer::Hdf5Writer(const std::filesystem::path& file, const FileFormat& format) : file_(file), part_(file) {
  silence_hdf5();
  const Hdf5Handle access = list_handle(H5Pcreate(H5P_FILE_ACCESS));
  // The newest layout that HDF5 1.10 reads: its metadata carry checksums.
  H5Pset_libver_bounds(access.id(), H5F_LIBVER_V110, H5F_LIBVER_V110);
  // The part has a lock already.
  H5Pset_file_locking(access.id(), false, true);
  handle_ = file_handle(H5Fcreate(part_.path().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id()));
  require(handle_.valid(), "{} (cannot be written: {})", file_.string(), system_reason());
  attribute("/", "format", format.name);
  attribute("/", "version", std::vector<std::int64_t>{format.version});
}

template <class T>
void Hdf5Writer::write(const std::string& dataset, const std::vector<T>& values, const DatasetLayout& layout) {
  const std::vector<std::size_t> shape = layout.shape.empty() ? std::vector<std::size_t>{values.size()} : layout.shape;
  require(product(shape) == values.size(), "{}: {}: {} values do not fill its shape", file_.string(), dataset,
          values.size());
  require(!layout.unit.empty(), "{}: {}: no unit given", file_.string(), dataset);
  const std::vector<hsize_t> extent(shape.begin(), shape.end());
  const Hdf5Handle space = space_handle(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr));
  const Hdf5Handle list = creation_list(shape, values.size() * sizeof(T));
  {
    const Hdf5Handle data = dataset_handle(H5Dcreate2(handle_.id(), dataset.c_str(), disk_type<T>(), space.id(),
                                                      with_groups().id(), list.id(), H5P_DEFAULT));
    const bool done = data.valid() && (values.empty() || H5Dwrite(data.id(), memory_type<T>(), H5S_ALL, H5S_ALL,
                                                                  H5P_DEFAULT, values.data()) >= 0);
    require(done, "{}: {}: cannot be written ({})", file_.string(), dataset, system_reason());
  }
  attribute(dataset, "unit", layout.unit);
}

void Hdf5Writer::write_text(const std::string& dataset, const std::string& text) {
  const Hdf5Handle type = text_type(text);
  const Hdf5Handle space = space_handle(H5Screate(H5S_SCALAR));
  const Hdf5Handle list = creation_list({}, 0);
  const Hdf5Handle data = dataset_handle(
      H5Dcreate2(handle_.id(), dataset.c_str(), type.id(), space.id(), with_groups().id(), list.id(), H5P_DEFAULT));
  const bool done =
      data.valid() && H5Dwrite(data.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, padded(text).c_str()) >= 0;
  require(done, "{}: {}: cannot be written ({})", file_.string(), dataset, system_reason());
}

template <class T>
void Hdf5Writer::attribute(const std::string& object, const std::string& name, const std::vector<T>& values) {
  const Hdf5Handle target = object_handle(H5Oopen(handle_.id(), object.c_str(), H5P_DEFAULT));
  const hsize_t count = values.size();
  const Hdf5Handle space = space_handle(count == 1 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &count, nullptr));
  const Hdf5Handle attribute =
      attribute_handle(H5Acreate2(target.id(), name.c_str(), disk_type<T>(), space.id(), H5P_DEFAULT, H5P_DEFAULT));
  require(attribute.valid() && H5Awrite(attribute.id(), memory_type<T>(), values.data()) >= 0,
          "{}: {}: attribute {} cannot be written ({})", file_.string(), object, name, system_reason());
}

void Hdf5Writer::attribute(const std::string& object, const std::string& name, const std::string& text) {
  const Hdf5Handle target = object_handle(H5Oopen(handle_.id(), object.c_str(), H5P_DEFAULT));
  const Hdf5Handle type = text_type(text);
  const Hdf5Handle space = space_handle(H5Screate(H5S_SCALAR));
  const Hdf5Handle attribute =
      attribute_handle(H5Acreate2(target.id(), name.c_str(), type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT));
  require(attribute.valid() && H5Awrite(attribute.id(), type.id(), padded(text).c_str()) >= 0,
          "{}: {}: attribute {} cannot be written ({})", file_.string(), object, name, system_reason());
}

void Hdf5Writer::group(const std::string& path) {
  const Hdf5Handle group =
      hdf5_handle<H5Gclose>(H5Gcreate2(handle_.id(), path.c_str(), with_groups().id(), H5P_DEFAULT, H5P_DEFAULT));
  require(group.valid(), "{}: {}: cannot be created ({})", file_.string(), path, system_reason());
}

void Hdf5Writer::require_written(bool done, const std::string& path) const {
  require(done, "{}: {}: cannot be written ({})", file_.string(), path, done ? "" : system_reason());
}

void Hdf5Writer::finish() {
  const bool flushed = H5Fflush(handle_.id(), H5F_SCOPE_LOCAL) >= 0;
  const std::string reason = flushed ? "" : system_reason();
  const bool closed = handle_.reset();
  require(flushed, "{} (cannot be written: {})", file_.string(), reason);
  require(closed, "{} (cannot be written: {})", file_.string(), system_reason());
  part_.publish();
}

template void Hdf5Writer::write(const std::string&, const std::vector<double>&, const DatasetLayout&);
template void Hdf5Writer::write(const std::string&, const std::vector<float>&, const DatasetLayout&);
template void Hdf5Writer::write(const std::string&, const std::vector<std::int64_t>&, const DatasetLayout&);
template void Hdf5Writer::write(const std::string&, const std::vector<std::uint64_t>&, const DatasetLayout&);
template void Hdf5Writer::write(const std::string&, const std::vector<std::uint8_t>&, const DatasetLayout&);
template void Hdf5Writer::attribute(const std::string&, const std::string&, const std::vector<double>&);
template void Hdf5Writer::attribute(const std::string&, const std::string&, const std::vector<std::int64_t>&);

}  // namespace clogflow
