#include "host/scene/items/key_list.hpp"

#include "host/scene/context/limits.hpp"
#include "host/scene/items/idle_laws.hpp"
#include "host/scene/values/key_order.hpp"
#include "host/scene/values/unseen_keys.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace kfast::scene {

bool KeyList::read(const kdl::Node& node)
{
    auto key = read_key(node, holder_, driver_, context_);
    if (!key || !in_order(*key))
        return false;
    keys_.push_back(std::move(*key));
    return true;
}

std::vector<ItemKey> KeyList::take()
{
    warn_of_idle_laws(keys_, context_);
    // The way to a key is seen in part if it begins before the end.
    if (driver_.is_time())
        take_times(keys_, 1, key_name, context_);
    return std::move(keys_);
}

bool KeyList::in_order(const ItemKey& key)
{
    if (keys_.size() == max_keys)
        return context_.report.error(key.place, "at most " + std::to_string(max_keys) + " keys stand here");
    return keys_.empty() || comes_later(key_name, {keys_.back().time, keys_.back().place},
                                        {key.time, key.place}, driver_, context_);
}

}
