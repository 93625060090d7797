#pragma once

#include "host/scene/context/scene_context.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace kfast::scene {

/// Warns of the first of `keys` of which nothing is seen because the scene ends before. Their times rise. Of
/// those that lie at the end or behind it, the first `in_use` still shape what is seen; `noun` is what a key
/// is called.
template <class Key>
void warn_of_unseen_keys(const std::vector<Key>& keys, std::ptrdiff_t in_use, std::string_view noun,
                         SceneContext& context)
{
    if (!context.length)
        return;
    const auto begins_too_late = [&](const Key& key) { return key.time >= *context.length; };
    const auto late = std::ranges::find_if(keys, begins_too_late);
    if (keys.end() - late > in_use)
        context.report.warning((late + in_use)->place,
                               "the scene ends before anything of this " + std::string{noun} + " is seen",
                               "make the scene longer with frames=… or remove the " + std::string{noun});
}

/// Likewise; and how far `keys` reach in time.
template <class Key>
void take_times(const std::vector<Key>& keys, std::ptrdiff_t in_use, std::string_view noun,
                SceneContext& context)
{
    warn_of_unseen_keys(keys, in_use, noun, context);
    if (!keys.empty())
        context.last_key = std::max(context.last_key, keys.back().time);
}

}
