#pragma once

#include "host/compiler/compile.hpp"
#include "host/text/reported_diagnostics.hpp"
#include "host/text/source.hpp"

#include <cstddef>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace kfast {

/// What the compiler made of a text, apart from what it said about it.
struct CompiledText {
    std::optional<std::vector<std::byte>> bytes; ///< present exactly when there were no errors
    std::vector<std::string> item_names;         ///< in the order in which the scene stores items
    std::vector<SourceSpan> item_places;         ///< in the text, in the same order
    StoredNames other_names;                     ///< of symbols, skeletons and bones
    std::size_t errors = 0;
    std::size_t warnings = 0;
};

/// Compiles a scene text and passes all diagnostics to `reporter`.
CompiledText compile_and_report(const SourceText& source, const Reporter& reporter = printing_to(std::cerr));

}
