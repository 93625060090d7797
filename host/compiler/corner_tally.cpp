#include "host/compiler/corner_tally.hpp"

#include <utility>

namespace kfast {

CornerTally::CornerTally()
{
    counts = counts_for(0);
    work_tally = this;
}

CornerTally::~CornerTally() { work_tally = nullptr; }

CornerTally::ByItem CornerTally::by_item() const
{
    ByItem corners;
    for (const auto& [path, counts_of_item] : done_)
        if (path != 0)
            corners[path] = counts_of_item[static_cast<std::size_t>(Work::corner)];
    return corners;
}

/// Outside of all items a picture ends, and the next one begins.
std::uint32_t* CornerTally::counts_for(std::uint32_t path)
{
    if (path == 0)
        done_ = std::exchange(begun_, {});
    return begun_[path].data();
}

}
