#include "host/lottie/drawings/moments.hpp"

#include <algorithm>

namespace kfast::lottie {

void Moments::add(const Moments& others)
{
    for (const auto& [time, other] : others.list_) {
        Moment& moment = list_[time];
        for (const art::Ease& ease : other.eases)
            add(moment, ease);
        moment.jump = moment.jump || other.jump;
    }
}

void Moments::add(Moment& moment, const art::Ease& ease)
{
    // Beyond a few, none governs everything: it is baked.
    constexpr std::size_t max_tried = 4;
    if (moment.eases.size() < max_tried && std::ranges::find(moment.eases, ease) == moment.eases.end())
        moment.eases.push_back(ease);
}

}
