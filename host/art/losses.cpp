#include "host/art/losses.hpp"

#include <algorithm>
#include <utility>

namespace kfast::art {

void Losses::add(Loss loss)
{
    if (std::ranges::find(list_, loss) != list_.end())
        return;
    if (list_.size() < max)
        list_.push_back(std::move(loss));
    else
        ++beyond_;
}

}
