// Reading: nothing is taken for granted, since a file may be old, damaged, or another program's.
#include "coupling/base/require.hpp"
#include "coupling/base/shown_text.hpp"
#include "coupling/files/hdf5_guard.hpp"
#include "coupling/files/hdf5_library.hpp"

namespace clogflow {
namespace {

/// What lies below a file lies in a pack; nothing else can.
bool is_in_pack(const std::filesystem::path& file) {
  std::error_code ignored;
  return file.has_filename() && std::filesystem::is_regular_file(file.parent_path(), ignored);
}

Hdf5Handle open_root(const std::filesystem::path& file) {
  silence_hdf5();
  if (is_in_pack(file)) {
    const Hdf5Handle pack = open_root(file.parent_path());
    const std::string name = file.filename().string();
    require(has_plain_link(pack.id(), name, file.string()), "{} (no such run in this pack)", file.string());
    Hdf5Handle run = group_handle(H5Gopen2(pack.id(), name.c_str(), H5P_DEFAULT));
    require(run.valid(), "{} (no run, or damaged)", file.string());
    return run;
  }
  require(std::filesystem::exists(file), "{} (no such file)", file.string());
  require(std::filesystem::is_regular_file(file), "{} (not a file)", file.string());
  require(H5Fis_hdf5(file.c_str()) > 0, "{} (not an HDF5 file, or cut off)", file.string());
  const Hdf5Handle access = list_handle(H5Pcreate(H5P_FILE_ACCESS));
  // A file that has its name is whole, and network file systems may refuse locks.
  H5Pset_file_locking(access.id(), false, true);
  Hdf5Handle handle = file_handle(H5Fopen(file.c_str(), H5F_ACC_RDONLY, access.id()));
  require(handle.valid(), "{} (damaged or cut off, or still being written)", file.string());
  return handle;
}

/// Of the file on the disk [byte]
std::uintmax_t size_of(const std::filesystem::path& file) {
  return std::filesystem::file_size(is_in_pack(file) ? file.parent_path() : file);
}

struct TextPlace {
  const std::filesystem::path& file;
  const std::string& name;
};

// A fixed-length text, without its padding.
template <class Read>
std::string read_fixed_text(const TextPlace& place, const Hdf5Handle& type, const Read& read) {
  const bool fixed = type.valid() && H5Tget_class(type.id()) == H5T_STRING && H5Tis_variable_str(type.id()) == 0;
  require(fixed, "{}: {} (must be a text of fixed length)", place.file.string(), place.name);
  const std::size_t size = H5Tget_size(type.id());
  require(size > 0 && size <= size_of(place.file), "{}: {} (damaged: a text of {} bytes)", place.file.string(),
          place.name, size);
  std::string text(size, '\0');
  require(read(type.id(), text.data()) >= 0, "{}: {} (damaged or cut off)", place.file.string(), place.name);
  text.resize(text.find_last_not_of('\0') + 1);
  return text;
}

bool is_scalar(const Hdf5Handle& space) { return space.valid() && H5Sget_simple_extent_npoints(space.id()) == 1; }

template <class T>
bool same_class(hid_t type) {
  if constexpr (std::is_floating_point_v<T>)
    return H5Tget_class(type) == H5T_FLOAT && H5Tget_size(type) <= sizeof(double);
  return H5Tget_class(type) == H5T_INTEGER && H5Tget_size(type) <= sizeof(T);
}

FileFormat format_of(const Hdf5Handle& root, const std::filesystem::path& file) {
  const auto has = [&](const char* name) { return H5Aexists(root.id(), name) > 0; };
  require(has("format") && has("version"), "{} (not a file of this program: no format and version at its root)",
          file.string());
  const Hdf5Handle format = attribute_handle(H5Aopen(root.id(), "format", H5P_DEFAULT));
  const Hdf5Handle version = attribute_handle(H5Aopen(root.id(), "version", H5P_DEFAULT));
  const std::string place = "/@format";
  require(format.valid() && version.valid() && is_scalar(space_handle(H5Aget_space(format.id()))) &&
              is_scalar(space_handle(H5Aget_space(version.id()))),
          "{} (damaged: format or version unreadable)", file.string());
  FileFormat found;
  found.name = read_fixed_text({file, place}, type_handle(H5Aget_type(format.id())),
                               [&](hid_t type, void* text) { return H5Aread(format.id(), type, text); });
  require(H5Aread(version.id(), H5T_NATIVE_INT, &found.version) >= 0, "{} (damaged: version unreadable)",
          file.string());
  return found;
}

struct AttributePlace {
  const std::filesystem::path& file;
  const std::string& object;
  std::string name;
};

Hdf5Handle open_attribute(hid_t object, const AttributePlace& place) {
  require(H5Aexists(object, place.name.c_str()) > 0, "{}: {} has no attribute \"{}\"", place.file.string(),
          place.object, place.name);
  return attribute_handle(H5Aopen(object, place.name.c_str(), H5P_DEFAULT));
}

std::string text_of_attribute(hid_t object, const AttributePlace& place) {
  const Hdf5Handle attribute = open_attribute(object, place);
  const std::string path = place.object + "@" + place.name;
  require(attribute.valid() && is_scalar(space_handle(H5Aget_space(attribute.id()))),
          "{}: {} (not a single text, or damaged)", place.file.string(), path);
  return read_fixed_text({place.file, path}, type_handle(H5Aget_type(attribute.id())),
                         [&](hid_t type, void* text) { return H5Aread(attribute.id(), type, text); });
}

std::string last_name(const std::string& path) { return path.substr(path.rfind('/') + 1); }

}  // namespace

Hdf5Reader::Hdf5Reader(const std::filesystem::path& file, const FileFormat& format)
    : file_(file), handle_(open_root(file)), size_(static_cast<double>(size_of(file))) {
  const FileFormat found = format_of(handle_, file);
  require(found.name == format.name, "{} (is a \"{}\" file, a \"{}\" file is needed)", file.string(),
          shown_text(found.name), format.name);
  require(found.version == format.version, "{} (has version {} of \"{}\", this program reads version {})",
          file.string(), found.version, format.name, format.version);
}

/// Every link on the way is followed by itself, for asking for "/a/b" fails hard where "/a" is missing.
/// \return nullptr where there is no such group
const Hdf5Handle* Hdf5Reader::open_group(const std::string& path) const {
  if (path.empty()) return &handle_;
  if (const auto known = groups_.find(path); known != groups_.end()) return &known->second;
  const Hdf5Handle* holder = holder_of(path);
  if (holder == nullptr) return nullptr;
  Hdf5Handle group = group_handle(H5Gopen2(holder->id(), last_name(path).c_str(), H5P_DEFAULT));
  return group.valid() ? &groups_.emplace(path, std::move(group)).first->second : nullptr;
}

/// The group that holds the last link of a path, or nullptr where there is none.
const Hdf5Handle* Hdf5Reader::holder_of(const std::string& path) const {
  const Hdf5Handle* group = open_group(path.substr(0, path.rfind('/')));
  try {
    return group != nullptr && has_plain_link(group->id(), last_name(path), path) ? group : nullptr;
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", file_.string(), error.what()));
  }
}

bool Hdf5Reader::has(const std::string& path) const { return path == "/" || holder_of(path) != nullptr; }

void Hdf5Reader::check(bool condition, const std::string& message) const {
  require(condition, "{}: {}", file_.string(), message);
}

// Many datasets may name the same stored bytes: their sum is bounded too.
void Hdf5Reader::spend(double bytes) const {
  unpacked_ += bytes;
  check(unpacked_ <= largest_ratio * size_,
        "unpacks to more than a file of its size can hold (made to fill the memory?)");
}

Hdf5Handle Hdf5Reader::open_dataset(const std::string& dataset) const {
  const Hdf5Handle* holder = dataset == "/" ? &handle_ : holder_of(dataset);
  check(holder != nullptr, dataset + " is missing");
  Hdf5Handle data = dataset_handle(H5Dopen2(holder->id(), last_name(dataset).c_str(), H5P_DEFAULT));
  check(data.valid(), dataset + " (not a dataset, or damaged)");
  const std::string wrong = storage_fault(data.id());
  check(wrong.empty(), fmt::format("{} ({})", dataset, wrong));
  return data;
}

template <class T>
Hdf5Array<T> Hdf5Reader::read(const std::string& dataset, const std::string& unit) const {
  const Hdf5Handle data = open_dataset(dataset);
  const std::string found = text_of_attribute(data.id(), {file_, dataset, "unit"});
  check(found == unit, fmt::format("{} has the unit \"{}\" (must be \"{}\")", dataset, shown_text(found), unit));
  const Hdf5Handle type = type_handle(H5Dget_type(data.id()));
  check(type.valid() && same_class<T>(type.id()),
        fmt::format("{} (must hold {} of at most {} bytes)", dataset,
                    std::is_floating_point_v<T> ? "floating-point numbers" : "whole numbers",
                    std::is_floating_point_v<T> ? 8 : sizeof(T)));
  const Hdf5Handle space = space_handle(H5Dget_space(data.id()));
  const int rank = space.valid() ? H5Sget_simple_extent_ndims(space.id()) : -1;
  check(rank >= 1, dataset + " (not an array, or damaged)");
  std::vector<hsize_t> extent(static_cast<std::size_t>(rank));
  H5Sget_simple_extent_dims(space.id(), extent.data(), nullptr);

  // A damaged size must not become an allocation.
  double bytes = sizeof(T);
  for (const hsize_t length : extent) bytes *= static_cast<double>(length);
  const std::string too_large = size_fault(data.id(), bytes);
  check(too_large.empty(), fmt::format("{} ({})", dataset, too_large));
  spend(bytes);

  Hdf5Array<T> array{.values = {}, .shape = {extent.begin(), extent.end()}};
  array.values.resize(static_cast<std::size_t>(bytes) / sizeof(T));
  if (array.values.empty()) return array;
  check(H5Dread(data.id(), memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, array.values.data()) >= 0,
        dataset + " (damaged or cut off)");
  return array;
}

std::string Hdf5Reader::read_text(const std::string& dataset) const {
  const Hdf5Handle data = open_dataset(dataset);
  check(is_scalar(space_handle(H5Dget_space(data.id()))), dataset + " (not a single text, or damaged)");
  return read_fixed_text({file_, dataset}, type_handle(H5Dget_type(data.id())), [&](hid_t type, void* text) {
    return H5Dread(data.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text);
  });
}

Hdf5Handle Hdf5Reader::open_object(const std::string& object) const {
  if (object == "/") return object_handle(H5Oopen(handle_.id(), ".", H5P_DEFAULT));
  const Hdf5Handle* holder = holder_of(object);
  check(holder != nullptr, object + " is missing");
  return object_handle(H5Oopen(holder->id(), last_name(object).c_str(), H5P_DEFAULT));
}

std::string Hdf5Reader::text_attribute(const std::string& object, const std::string& name) const {
  return text_of_attribute(open_object(object).id(), {file_, object, name});
}

std::vector<double> Hdf5Reader::number_attribute(const std::string& object, const std::string& name) const {
  const std::string path = object + "@" + name;
  const Hdf5Handle target = open_object(object);
  const Hdf5Handle attribute = open_attribute(target.id(), {file_, object, name});
  const Hdf5Handle space = space_handle(attribute.valid() ? H5Aget_space(attribute.id()) : -1);
  const hssize_t count = space.valid() ? H5Sget_simple_extent_npoints(space.id()) : -1;
  constexpr hssize_t most = 1000;
  check(count >= 0 && count <= most, path + " (damaged)");
  const Hdf5Handle type = type_handle(H5Aget_type(attribute.id()));
  check(same_class<double>(type.id()) || same_class<std::int64_t>(type.id()), path + " (must be numbers)");
  std::vector<double> values(static_cast<std::size_t>(count));
  check(H5Aread(attribute.id(), H5T_NATIVE_DOUBLE, values.data()) >= 0, path + " (damaged)");
  return values;
}

FileFormat file_format(const std::filesystem::path& file) { return format_of(open_root(file), file); }

template Hdf5Array<double> Hdf5Reader::read(const std::string&, const std::string&) const;
template Hdf5Array<float> Hdf5Reader::read(const std::string&, const std::string&) const;
template Hdf5Array<std::int64_t> Hdf5Reader::read(const std::string&, const std::string&) const;
template Hdf5Array<std::uint64_t> Hdf5Reader::read(const std::string&, const std::string&) const;
template Hdf5Array<std::uint8_t> Hdf5Reader::read(const std::string&, const std::string&) const;

}  // namespace clogflow
