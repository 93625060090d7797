#pragma once

#include "host/kdl/document.hpp"
#include "host/text/diagnostic.hpp"

#include <optional>
#include <string_view>

namespace kfast::kdl {

/// Parses a KDL 2.0 document. Any bytes are allowed in `text`.
///
/// Errors go to `diagnostics`; after an error the parser goes on at the next node, so that one run finds
/// several. Returns what could be read even then: ask `diagnostics.has_errors()`. Nodes nested deeper than
/// 256 are refused.
Document parse(std::string_view text, Diagnostics& diagnostics);

}
