#include "coupling/base/shown_text.hpp"

#include <algorithm>

namespace clogflow {

std::string shown_text(std::string_view text, std::size_t longest) {
  std::size_t length = std::min(text.size(), longest);
  const auto continues = [&](std::size_t at) { return (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80; };
  // Not in the middle of a character; what is no UTF-8 may be cut anywhere.
  for (int back = 0; back < 3 && length > 0 && length < text.size() && continues(length); ++back) --length;
  std::string shown(text.substr(0, length));
  std::ranges::replace_if(
      shown, [](unsigned char c) { return c < ' ' || c == 0x7f; }, ' ');
  return length < text.size() ? shown + "..." : shown;
}

}  // namespace clogflow
