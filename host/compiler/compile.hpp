#pragma once

#include "host/tell_work.hpp"
#include "host/text/diagnostic.hpp"
#include "host/text/source.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace kfast {

/// A .kfb, and what it does not hold.
struct CompiledScene {
    std::vector<std::byte> bytes;
    std::vector<std::string> item_names; ///< in the order in which the scene stores items; may be empty
    std::vector<Place> item_places;      ///< likewise, in the text
};

/// Compiles a .kfast text into the bytes of a .kfb (docs/format.md).
///
/// Errors and warnings go to `diagnostics`; there are bytes exactly when there was no error.
std::optional<std::vector<std::byte>> compile(const SourceText& source, Diagnostics& diagnostics);

/// As compile(), with the names of items.
std::optional<CompiledScene> compile_with_names(const SourceText& source, Diagnostics& diagnostics,
                                                const TellWork& tell = tell_nobody);

}
