#pragma once

#include "host/text/diagnostic.hpp"
#include "host/text/source.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace kfast {

/// Compiles a .kfast text into the bytes of a .kfb (docs/format.md).
///
/// Errors and warnings go to `diagnostics`; there are bytes exactly when there was no error.
std::optional<std::vector<std::byte>> compile(const SourceText& source, Diagnostics& diagnostics);

}
