#include "coupling/files/hdf5_guard.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "coupling/base/require.hpp"
#include "coupling/files/hdf5_library.hpp"

namespace clogflow {
namespace {

// Each at most once: twice deflated shrinks a million times.
std::string filter_fault(hid_t list) {
  const int count = H5Pget_nfilters(list);
  std::set<H5Z_filter_t> seen;
  for (int k = 0; k < count; ++k) {
    unsigned flags = 0, settings = 0;
    std::size_t values = 0;
    const H5Z_filter_t filter =
        H5Pget_filter2(list, static_cast<unsigned>(k), &flags, &values, nullptr, 0, nullptr, &settings);
    const bool ours = filter == H5Z_FILTER_DEFLATE || filter == H5Z_FILTER_SHUFFLE || filter == H5Z_FILTER_FLETCHER32;
    if (!ours) return fmt::format("packed by filter {}: only deflate, shuffle and fletcher32 are read", filter);
    if (!seen.insert(filter).second) return fmt::format("packed twice by filter {}", filter);
  }
  return count < 0 ? "damaged" : "";
}

// The library unpacks a piece whole, however little of it the dataset uses.
double chunk_bytes(hid_t list, hid_t dataset) {
  std::array<hsize_t, H5S_MAX_RANK> chunk{};
  const int rank = H5Pget_chunk(list, H5S_MAX_RANK, chunk.data());
  const Hdf5Handle type = type_handle(H5Dget_type(dataset));
  double bytes = type.valid() ? static_cast<double>(H5Tget_size(type.id())) : 0;
  for (int axis = 0; axis < rank; ++axis) bytes *= static_cast<double>(chunk[static_cast<std::size_t>(axis)]);
  return bytes;
}

}  // namespace

bool has_plain_link(std::int64_t group, const std::string& name, const std::string& path) {
  H5L_info_t link{};
  if (H5Lget_info(group, name.c_str(), &link, H5P_DEFAULT) < 0) return false;
  require(link.type == H5L_TYPE_HARD, "{} (a link to another place or file: links are not followed)", path);
  return true;
}

std::string storage_fault(std::int64_t dataset) {
  const Hdf5Handle list = list_handle(H5Dget_create_plist(dataset));
  if (!list.valid()) return "damaged";
  const H5D_layout_t layout = H5Pget_layout(list.id());
  if (layout == H5D_VIRTUAL || H5Pget_external_count(list.id()) != 0)
    return "its values are kept in another file: only what is in this one is read";
  if (layout != H5D_CHUNKED) return layout < 0 ? "damaged" : "";
  // Ours have a mebibyte, or one row of a grid.
  constexpr double largest_chunk = 1 << 28;
  if (chunk_bytes(list.id(), dataset) > largest_chunk) return "stored in pieces of over 256 MiB";
  return filter_fault(list.id());
}

std::string size_fault(std::int64_t dataset, double bytes) {
  const double stored = static_cast<double>(H5Dget_storage_size(dataset));
  return bytes <= largest_ratio * stored ? "" : "damaged: larger than what is stored";
}

}  // namespace clogflow
