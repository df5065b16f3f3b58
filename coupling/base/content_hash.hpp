// A short name for a text: same text, same name, on any machine.
#pragma once

#include <string>

namespace clogflow {

/// 64-bit FNV-1a of a text as 16 hexadecimal digits: names a flow by its inputs.
/// Not cryptographic: it guards against mix-ups, not against malice.
/// \source G. Fowler, L. C. Noll, K.-P. Vo: the FNV hash, 64-bit parameters
std::string content_hash(const std::string& text);

}  // namespace clogflow
