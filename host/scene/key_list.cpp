#include "host/scene/key_list.hpp"

#include "host/scene/idle_laws.hpp"
#include "host/scene/limits.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace kfast::scene {

bool KeyList::read(const kdl::Node& node)
{
    auto key = read_key(node, holder_, reading_);
    if (!key || !in_order(*key))
        return false;
    keys_.push_back(std::move(*key));
    return true;
}

std::vector<ItemKey> KeyList::take()
{
    warn_of_idle_laws(keys_, reading_);
    warn_of_unseen_keys();
    if (!keys_.empty())
        reading_.last_key = std::max(reading_.last_key, keys_.back().time);
    return std::move(keys_);
}

bool KeyList::in_order(const ItemKey& key)
{
    if (keys_.size() == most_keys)
        return reading_.report.error(key.place, "at most " + std::to_string(most_keys) + " keys stand here");
    if (keys_.empty() || keys_.back().time < key.time)
        return true;
    return report_order(key, keys_.back());
}

bool KeyList::report_order(const ItemKey& key, const ItemKey& before)
{
    const std::string line = reading_.report.line(before.place);
    if (key.time == before.time)
        return reading_.report.error(key.place, "there is a key at this time already, on " + line,
                                     "times are rounded to 1/1024 frame; choose another");
    return reading_.report.error(key.place, "this key is earlier than the one before it, on " + line,
                                 "put the keys in the order of their times");
}

/// The way to a key is seen in part if it begins before the end.
void KeyList::warn_of_unseen_keys()
{
    if (!reading_.length)
        return;
    const auto begins_too_late = [&](const ItemKey& key) { return key.time >= *reading_.length; };
    const auto late = std::ranges::find_if(keys_, begins_too_late);
    if (keys_.end() - late > 1)
        reading_.report.warning((late + 1)->place, "the scene ends before anything of this key is seen",
                                "make the scene longer with frames=… or remove the key");
}

}
