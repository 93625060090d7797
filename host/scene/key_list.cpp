#include "host/scene/key_list.hpp"

#include "host/scene/key_reader.hpp"
#include "host/scene/limits.hpp"
#include "host/scene/shape_reader.hpp"
#include "host/text/glyph.hpp"
#include "host/text/suggestion.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kfast::scene {
void KeyList::read(const kdl::Node& node)
{
    if (node.name == key_name)
        add_key(node);
    else if (is_shape(node.name))
        add_shape(node);
    else
        report_unknown(node);
}

void KeyList::finish()
{
    if (has_shape_)
        object_.keys.push_back({.time = {}, .drawing = still_.take(), .place = object_.place});
    else if (const auto law = last_key_ != nullptr ? law_place(*last_key_) : std::nullopt)
        reading_.report.warning(*law, "a law on the last key governs nothing",
                                "remove it, or add a later key");
}

void KeyList::add_key(const kdl::Node& node)
{
    if (has_shape_)
        return report_mixture(node);
    last_key_ = &node;
    auto key = read_key(node, reading_);
    if (key && in_order(*key))
        object_.keys.push_back(std::move(*key));
}

void KeyList::add_shape(const kdl::Node& node)
{
    if (last_key_ != nullptr)
        return report_mixture(node);
    has_shape_ = true;
    still_.read(node);
}

bool KeyList::in_order(const Key& key)
{
    if (object_.keys.size() == most_keys)
        return reading_.report.error(key.place,
                                     "an object holds at most " + std::to_string(most_keys) + " keys");
    if (object_.keys.empty() || object_.keys.back().time < key.time)
        return true;
    return report_order(key, object_.keys.back());
}

bool KeyList::report_order(const Key& key, const Key& before)
{
    const std::string line = reading_.report.line(before.place);
    if (key.time == before.time)
        return reading_.report.error(key.place, "there is a key at this time already, on " + line,
                                     "times are rounded to 1/1024 frame; choose another");
    return reading_.report.error(key.place, "this key is earlier than the one before it, on " + line,
                                 "put the keys in the order of their times");
}

void KeyList::report_mixture(const kdl::Node& node)
{
    if (!std::exchange(mixed_, true))
        reading_.report.error(node.name_place, "an object has either keys or shapes, not both",
                              "put the shapes into a key: key 0 { … }");
}

void KeyList::report_unknown(const kdl::Node& node)
{
    std::vector<std::string_view> known{key_name};
    known.insert(known.end(), shape_names().begin(), shape_names().end());
    reading_.report.error(node.name_place, "an object has no node " + quoted(node.name),
                          suggestion(node.name, known));
}

}
