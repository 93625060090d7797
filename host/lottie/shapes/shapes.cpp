#include "host/lottie/shapes/shapes.hpp"

#include "host/lottie/drawings/rounded_corners.hpp"
#include "host/lottie/drawings/trim.hpp"
#include "host/lottie/shapes/path_item.hpp"
#include "host/lottie/shapes/repeater.hpp"
#include "host/lottie/shapes/shape_members.hpp"
#include "host/lottie/shapes/shape_tree.hpp"
#include "host/lottie/shapes/style_item.hpp"
#include "host/lottie/values/member.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace kfast::lottie {
namespace {

void report(const Reading& reading, std::string feature, std::string instead)
{
    reading.losses.add({std::move(feature), reading.layer, std::nullopt, std::move(instead)});
}

Trim read_trim(const Json& item, const Reading& reading)
{
    const auto channel = [&](const char* name, double default_value, double factor) {
        return read_channel(item, name, 0, default_value, factor, reading.time, reading.budget);
    };
    constexpr int one_after_another = 2;
    return {channel("s", 0, 0.01), channel("e", 1, 0.01), channel("o", 0, 1.0 / 360),
            whole_at(item, "m", 1) == one_after_another};
}

/// What changes paths, and is not carried over.
struct Modifier {
    const char* type;
    const char* name;
};

constexpr std::array unknown_modifiers{Modifier{"pb", "pucker and bloat"}, Modifier{"zz", "zig zag"},
                                       Modifier{"tw", "twist"}, Modifier{"op", "offset paths"}};

/// The items of a list, from its first one to the one that is read now.
class ItemList {
public:
    explicit ItemList(const Reading& reading) : reading_{reading} {}

    void read(const Json& item)
    {
        if (!item.is_object())
            throw WrongMember(item, "is no shape: one is an object with \"ty\"");
        if (truth_at(item, "hd", false) || !truth_at(item, "fillEnabled", true))
            return;
        reading_.budget.take_node();
        const std::string type = text_at(item, "ty");
        report_blend_mode(item);
        report_unknown_members(item, type, reading_);
        if (is_path(type))
            items_.push_back({read_path_item(item, reading_)});
        else if (is_style(type))
            items_.push_back({read_style_item(item, reading_)});
        else if (type == "gr")
            items_.push_back({read_group(item)});
        else if (type != "tr") // that of the list itself, which its group has read
            modify(type, item);
    }

    std::vector<ShapeItem> finish() { return std::move(items_); }

private:
    /// Each puts all before it into groups.
    static constexpr int max_repeaters = 8;
    static constexpr int max_modifiers = 64;

    void report_blend_mode(const Json& item) const
    {
        if (number_at(item, "bm", 0) != 0)
            report(reading_, "blend mode", "what lies above covers what lies below");
    }

    GroupItem read_group(const Json& item) const;

    void modify(const std::string& type, const Json& item)
    {
        if (type == "tm")
            trim(read_trim(item, reading_), modified_paths(item));
        else if (type == "rd")
            round_corners(item);
        else if (type == "rp")
            repeat(item);
        else if (type == "mm")
            report_merge(item);
        else
            report_unknown(type);
    }

    std::vector<MovingDrawing*> modified_paths(const Json& item)
    {
        std::vector<MovingDrawing*> drawings;
        for (PathItem* path : paths_of(items_)) {
            if (++path->modifiers > max_modifiers)
                throw WrongMember(item, "is the 65th that changes one path: take some of them away");
            path->plain.reset();
            drawings.push_back(&path->drawing);
        }
        return drawings;
    }

    void round_corners(const Json& item)
    {
        const art::Channel radius = read_channel(item, "r", 0, 0, 1, reading_.time, reading_.budget);
        for (MovingDrawing* drawing : modified_paths(item))
            *drawing = with_rounded_corners(std::move(*drawing), radius);
    }

    void repeat(const Json& item)
    {
        if (++repeaters_ > max_repeaters)
            throw WrongMember(item, "is the ninth repeater of one list: put some of the shapes into a group");
        items_ = repeated(items_, item, reading_);
    }

    void report_merge(const Json& item)
    {
        static constexpr std::array<std::string_view, 6> modes{"",         "",          "add",
                                                               "subtract", "intersect", "exclude"};
        const int mode = whole_at(item, "mm", 1);
        if (mode <= 1 || paths_of(items_).size() < 2)
            return;
        const std::string name = mode < static_cast<int>(modes.size())
                                     ? std::string{modes[static_cast<std::size_t>(mode)]}
                                     : "mode " + std::to_string(mode);
        report(reading_, "merge paths: " + name, "the outlines together, as the rule of the fill has it");
    }

    void report_unknown(const std::string& type)
    {
        const auto known = std::ranges::find(unknown_modifiers, type, &Modifier::type);
        if (known != unknown_modifiers.end())
            report(reading_, known->name, "the paths as they are without it");
        else
            report(reading_, "shape of type \"" + type + '"', "nothing");
    }

    const Reading& reading_;
    std::vector<ShapeItem> items_;
    int repeaters_ = 0;
};

std::vector<ShapeItem> read_list(const Json& list, const Reading& reading)
{
    ItemList items{reading};
    for (const Json& item : list)
        items.read(item);
    return items.finish();
}

const Json* find_transform(const Json& list)
{
    for (const Json& item : list)
        if (item.is_object() && text_at(item, "ty") == "tr")
            return &item;
    return nullptr;
}

GroupItem ItemList::read_group(const Json& item) const
{
    Reading inner{reading_};
    GroupItem group;
    group.name = text_at(item, "nm");
    if (!group.name.empty())
        inner.layer += " / " + group.name;
    art::Budget::check_depth(++inner.depth);
    if (!find_member(item, "it"))
        return group;
    const Json& list = array_at(item, "it");
    if (const Json* const transform = find_transform(list)) {
        group.transform = read_transform(*transform, inner);
        group.opacity = read_channel(*transform, "o", 0, 1, 0.01, inner.time, inner.budget);
    }
    group.items = read_list(list, inner);
    return group;
}

}

std::vector<art::Node> read_shapes(const Json& shapes, const Reading& reading)
{
    if (!shapes.is_array())
        throw WrongMember(shapes, "is no list of shapes: export the file again");
    return painted(read_list(shapes, reading), reading);
}

}
