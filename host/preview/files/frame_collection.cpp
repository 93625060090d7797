#include "host/preview/files/frame_collection.hpp"

#include <algorithm>
#include <utility>

namespace kfast {

FrameCollection::FrameCollection(std::vector<Time> moments) : moments_{std::move(moments)}
{
    std::ranges::sort(moments_);
    moments_.erase(std::unique(moments_.begin(), moments_.end()), moments_.end());
}

void FrameCollection::add_next(FrameSource& source)
{
    const Frame& frame = source.show(moments_[done()]);
    frames_.push_back({frame, source.facts()});
}

const FrameCollection::Drawn* FrameCollection::at(Time moment) const
{
    const auto place = std::ranges::lower_bound(moments_, moment);
    const auto index = static_cast<std::size_t>(place - moments_.begin());
    const bool is_known = place != moments_.end() && *place == moment && index < done();
    return is_known ? &frames_[index] : nullptr;
}

}
