#include "coupling/files/run_pack.hpp"

#include <algorithm>
#include <functional>

#include "coupling/base/require.hpp"
#include "coupling/files/hdf5_guard.hpp"
#include "coupling/files/hdf5_library.hpp"

namespace clogflow {
namespace {

using Names = std::vector<std::string>;

herr_t take_link(hid_t, const char* name, const H5L_info_t*, void* names) {
  static_cast<Names*>(names)->push_back(name);
  return 0;
}

herr_t take_attribute(hid_t, const char* name, const H5A_info_t*, void* names) {
  static_cast<Names*>(names)->push_back(name);
  return 0;
}

Names links_of(hid_t group) {
  Names names;
  H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, take_link, &names);
  return names;
}

Names attributes_of(hid_t object) {
  Names names;
  H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, take_attribute, &names);
  return names;
}

/// Stored bytes of a dataset or an attribute.
struct Stored {
  Hdf5Handle type, space;
  std::string bytes;
};

Stored stored(hid_t type, hid_t space, const std::function<herr_t(hid_t, void*)>& read, const std::string& path) {
  Stored result{type_handle(type), space_handle(space), {}};
  const hssize_t count = H5Sget_simple_extent_npoints(space);
  require(type >= 0 && count >= 0, "{} (damaged)", path);
  result.bytes.resize(static_cast<std::size_t>(count) * H5Tget_size(type));
  require(result.bytes.empty() || read(type, result.bytes.data()) >= 0, "{} (damaged or cut off)", path);
  return result;
}

bool same(const Stored& a, const Stored& b) {
  return H5Tequal(a.type.id(), b.type.id()) > 0 && H5Sextent_equal(a.space.id(), b.space.id()) > 0 &&
         a.bytes == b.bytes;
}

Stored stored_attribute(hid_t object, const std::string& name, const std::string& path) {
  const Hdf5Handle attribute = attribute_handle(H5Aopen(object, name.c_str(), H5P_DEFAULT));
  require(attribute.valid(), "{}@{} (damaged)", path, name);
  return stored(
      H5Aget_type(attribute.id()), H5Aget_space(attribute.id()),
      [&](hid_t type, void* bytes) { return H5Aread(attribute.id(), type, bytes); }, path + "@" + name);
}

Stored stored_in(hid_t dataset, const std::string& path) {
  return stored(
      H5Dget_type(dataset), H5Dget_space(dataset),
      [&](hid_t type, void* bytes) { return H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes); }, path);
}

std::string difference(hid_t a, hid_t b, const std::string& path) {
  if (H5Iget_type(a) != H5Iget_type(b)) return path;
  const Names attributes = attributes_of(a);
  if (attributes != attributes_of(b)) return path;
  for (const std::string& name : attributes)
    if (!same(stored_attribute(a, name, path), stored_attribute(b, name, path))) return path + "@" + name;
  if (H5Iget_type(a) == H5I_DATASET) return same(stored_in(a, path), stored_in(b, path)) ? "" : path;
  const Names names = links_of(a);
  if (names != links_of(b)) return path;
  for (const std::string& name : names) {
    const std::string below = (path == "/" ? "" : path) + "/" + name;
    const Hdf5Handle in_a = object_handle(H5Oopen(a, name.c_str(), H5P_DEFAULT)),
                     in_b = object_handle(H5Oopen(b, name.c_str(), H5P_DEFAULT));
    require(in_a.valid() && in_b.valid(), "{} (damaged)", below);
    if (std::string found = difference(in_a.id(), in_b.id(), below); !found.empty()) return found;
  }
  return {};
}

/// Copies objects piece by piece: H5Ocopy, which would do it at once, crashes when the disk is full.
class Copier {
public:
  explicit Copier(const Hdf5Writer& out) : out_(out) {}

  void copy(hid_t from, hid_t to_group, const std::string& name, const std::string& path) const {
    H5Iget_type(from) == H5I_DATASET ? copy_dataset(from, to_group, name, path)
                                     : copy_group(from, to_group, name, path);
  }

private:
  void copy_group(hid_t from, hid_t to_group, const std::string& name, const std::string& path) const {
    const Hdf5Handle made = group_handle(H5Gcreate2(to_group, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    out_.require_written(made.valid(), path);
    copy_attributes(from, made.id(), path);
    for (const std::string& each : links_of(from)) {
      const std::string below = path + "/" + each;
      require(has_plain_link(from, each, below), "{} (damaged)", below);
      const Hdf5Handle object = object_handle(H5Oopen(from, each.c_str(), H5P_DEFAULT));
      require(object.valid(), "{} (damaged)", below);
      copy(object.id(), made.id(), each, below);
    }
  }

  void copy_dataset(hid_t from, hid_t to_group, const std::string& name, const std::string& path) const {
    const std::string wrong = storage_fault(from);
    require(wrong.empty(), "{} ({})", path, wrong);
    const Stored values = stored_in(from, path);
    const Hdf5Handle list = list_handle(H5Dget_create_plist(from));
    const Hdf5Handle made = dataset_handle(
        H5Dcreate2(to_group, name.c_str(), values.type.id(), values.space.id(), H5P_DEFAULT, list.id(), H5P_DEFAULT));
    out_.require_written(
        made.valid() && (values.bytes.empty() || H5Dwrite(made.id(), values.type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT,
                                                          values.bytes.data()) >= 0),
        path);
    copy_attributes(from, made.id(), path);
  }

  void copy_attributes(hid_t from, hid_t to, const std::string& path) const {
    for (const std::string& name : attributes_of(from)) {
      const Stored value = stored_attribute(from, name, path);
      const Hdf5Handle made =
          attribute_handle(H5Acreate2(to, name.c_str(), value.type.id(), value.space.id(), H5P_DEFAULT, H5P_DEFAULT));
      out_.require_written(made.valid() && H5Awrite(made.id(), value.type.id(), value.bytes.data()) >= 0, path);
    }
  }

  const Hdf5Writer& out_;
};

}  // namespace

void RunPackWriter::add(const std::filesystem::path& run_file) {
  const Hdf5Reader in(run_file, {.name = "clogflow run", .version = 1});
  const Hdf5Handle root = object_handle(H5Oopen(in.root().id(), ".", H5P_DEFAULT));
  try {
    Copier(out_).copy(root.id(), out_.root().id(), run_file.filename().string(), run_file.string());
  } catch (const Error& error) {
    throw Error(fmt::format("{} (copying {})", error.what(), run_file.string()));
  }
}

std::vector<std::filesystem::path> runs_in_pack(const std::filesystem::path& pack) {
  const Hdf5Reader in(pack, pack_format);
  std::vector<std::filesystem::path> runs;
  for (const std::string& name : links_of(in.root().id()))
    if (name.starts_with("run_") && name.ends_with(".h5")) runs.push_back(pack / name);
  std::ranges::sort(runs);
  in.check(!runs.empty(), "holds no run");
  return runs;
}

std::string run_difference(const std::filesystem::path& a, const std::filesystem::path& b) {
  const Hdf5Reader in_a(a, file_format(a)), in_b(b, file_format(b));
  try {
    // The root of a file and a group of a pack are both groups when they are opened as objects.
    const Hdf5Handle root_a = object_handle(H5Oopen(in_a.root().id(), ".", H5P_DEFAULT)),
                     root_b = object_handle(H5Oopen(in_b.root().id(), ".", H5P_DEFAULT));
    return difference(root_a.id(), root_b.id(), "/");
  } catch (const Error& error) {
    throw Error(fmt::format("{} or {}: {}", a.string(), b.string(), error.what()));
  }
}

}  // namespace clogflow
