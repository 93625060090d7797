#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace kfast::importing {

enum class ContentKind : std::uint8_t {
    json,
    xml,
    zip,
    gzip,
    utf_16, ///< JSON or XML in an encoding that is not read
};

/// The kind by the first bytes, byte order marks and white space aside; nothing for other content, such as
/// texts and compiled scenes of kfast.
std::optional<ContentKind> kind_of(std::string_view content);

/// Whether the content of a file is of a kind that may be imported: no scene text and no compiled scene is.
inline bool can_import(std::string_view content) { return kind_of(content).has_value(); }

/// The name of the outermost element of an XML text, without its namespace, or "" if there is none.
std::string_view root_element(std::string_view xml);

}
