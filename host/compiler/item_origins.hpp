#pragma once

#include "host/compiler/compile.hpp"
#include "host/scene/model.hpp"
#include "host/text/source.hpp"

#include <string>
#include <vector>

namespace kfast {

/// Where the items of a .kfb come from, in the order in which it stores them, as every_item() reads them.
struct ItemOrigins {
    std::vector<std::string> names; ///< of a use without a name that of its symbol
    std::vector<SourceSpan> places; ///< in the text
    StoredNames other_names;        ///< of symbols, skeletons and bones
};

ItemOrigins item_origins(const scene::Scene& scene);

}
