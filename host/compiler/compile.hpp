#pragma once

#include "host/program/progress_callback.hpp"
#include "host/text/diagnostic.hpp"
#include "host/text/source.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace kfast {

/// The names of a skeleton and its bones, in the order in which the scene stores the bones.
struct SkeletonNames {
    std::string name;
    std::vector<std::string> bones;
};

/// The names of what a scene stores besides items, in the order in which it stores them. A .kfb holds no
/// names: then there are none.
struct StoredNames {
    std::vector<std::string> symbols;
    std::vector<SkeletonNames> skeletons;
};

/// A .kfb, and what it does not hold.
struct CompiledScene {
    std::vector<std::byte> bytes;
    std::vector<std::string> item_names; ///< in the order in which the scene stores items; may be empty
    std::vector<SourceSpan> item_places; ///< in the text, in the same order
    StoredNames other_names;             ///< of symbols, skeletons and bones
};

/// Compiles a .kfast text into the bytes of a .kfb (docs/format.md).
///
/// Errors and warnings go to `diagnostics`; there are bytes exactly when there was no error.
std::optional<std::vector<std::byte>> compile(const SourceText& source, Diagnostics& diagnostics);

/// As compile(), with the names of items.
std::optional<CompiledScene> compile_with_names(const SourceText& source, Diagnostics& diagnostics,
                                                const ProgressCallback& on_progress = ignore_progress);

}
