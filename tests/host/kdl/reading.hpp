#pragma once

#include <string>
#include <string_view>

namespace kfast::test {

/// The canonical form of a document, or its errors if it has any.
std::string reading(std::string_view text);

/// What is wrong with a document: `line:column: message` for each error and warning, a line each.
std::string errors(std::string_view text);

/// The hint of the first of them.
std::string hint(std::string_view text);

}
