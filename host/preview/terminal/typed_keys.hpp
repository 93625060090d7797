#pragma once

#include "host/preview/controls/preview_key.hpp"

#include <string_view>
#include <vector>

namespace kfast {

/// The keys that a terminal means by `bytes`; what is none of a preview's keys is passed over. An escape at
/// the very end is the key of that name.
std::vector<PreviewKey> typed_keys(std::string_view bytes);

}
