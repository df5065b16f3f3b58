// Checks of programmer mistakes; what a user can cause is for require().
#pragma once

#include <cassert>

/// Ends the program with file and line unless the condition holds; nothing at all in a release build. For what the code
/// around it guarantees: sizes that agree, indices in range, rows in order.
#define expect(...) assert((__VA_ARGS__))
