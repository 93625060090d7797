#pragma once

#include "host/text/source.hpp"

#include <string>
#include <string_view>

namespace kfast {

/// The part of a line that is shown around a place, and the marks that go under it.
struct Excerpt {
    std::string line;
    std::string marks; ///< spaces, then ^~~~ under the place
};

/// At most about 120 columns of the line that holds `place`; what is cut is replaced by ….
Excerpt excerpt(std::string_view text, SourceSpan place);

}
