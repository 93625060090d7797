#include "host/lottie/shapes/shapes.hpp"

#include "host/art/animation/clamped_channel.hpp"
#include "host/lottie/drawings/modifiers.hpp"
#include "host/lottie/values/json.hpp"
#include "host/text/characters.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

namespace kfast::lottie {

namespace {

struct TypeMembers {
    std::string_view type;
    std::string_view names; ///< with a blank around each
};

/// Names, identities for expressions, and what tools keep for themselves.
constexpr std::string_view of_all = " ty nm mn hd bm ix ind cix cl ln np ";

constexpr std::array members_of_types{
    TypeMembers{"gr", " it "},
    TypeMembers{"tr", " p a s r o sk sa "},
    TypeMembers{"sh", " ks d closed "},
    TypeMembers{"rc", " p s r d closed "},
    TypeMembers{"el", " p s d closed "},
    TypeMembers{"sr", " sy p pt r or os ir is d closed "},
    TypeMembers{"fl", " c o r fillEnabled "},
    TypeMembers{"st", " c o w lc lj ml ml2 d fillEnabled "},
    TypeMembers{"gf", " g s e t h a o r "},
    TypeMembers{"gs", " g s e t h a o w lc lj ml ml2 d "},
    TypeMembers{"tm", " s e o m "},
    TypeMembers{"rd", " r "},
    TypeMembers{"rp", " c o m tr "},
    TypeMembers{"mm", " mm "},
};

bool holds(std::string_view names, std::string_view name)
{
    return names.find(' ' + std::string{name} + ' ') != names.npos;
}

/// Reports the members of a shape of that type "ty" that nothing reads. Those of unknown types are
/// ignored.
void report_unknown_members(const Json& item, std::string_view type, const Reading& reading)
{
    const auto known = std::ranges::find(members_of_types, type, &TypeMembers::type);
    if (known == members_of_types.end())
        return;
    for (const auto& [name, member] : item.items())
        if (!holds(of_all, name) && !holds(known->names, name))
            reading.losses.add({"member " + in_quotes(name) + " of a shape \"" + std::string{type} + '"',
                                reading.layer, std::nullopt, "it is not looked at"});
}

void report(const Reading& reading, std::string feature, std::string instead)
{
    reading.losses.add({std::move(feature), reading.layer, std::nullopt, std::move(instead)});
}

art::Trim read_trim(const Json& item, const Reading& reading)
{
    const auto channel = [&](const char* name, double default_value, double factor) {
        return read_channel(item, name, 0, default_value, factor, reading.time, reading.budget);
    };
    const auto share = [&](const char* name, double default_value) {
        return art::clamped(channel(name, default_value, 0.01), 0, 1);
    };
    constexpr int one_after_another = 2;
    return {share("s", 0), share("e", 1), channel("o", 0, 1.0 / 360),
            whole_at(item, "m", 1) == one_after_another};
}

/// What changes paths, and is not imported.
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
    /// Each puts everything before it into groups.
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
            trim_paths(item);
        else if (type == "rd")
            round_corners(item);
        else if (type == "rp")
            repeat(item);
        else if (type == "mm")
            report_merge(item);
        else
            report_unknown(type);
    }

    std::vector<PathItem*> modified_paths(const Json& item)
    {
        part_copies(items_);
        std::vector<PathItem*> paths = paths_of(items_);
        for (PathItem* path : paths) {
            if (++path->modifiers > max_modifiers)
                throw WrongMember(item, "is the 65th that changes one path: take some of them away");
            path->plain.reset();
            path->untrimmed.reset();
        }
        return paths;
    }

    void trim_paths(const Json& item)
    {
        const auto trim = std::make_shared<const art::Trim>(read_trim(item, reading_));
        const std::vector<PathItem*> paths = modified_paths(item);
        std::vector<MovingDrawing*> drawings;
        for (std::size_t i = 0; i < paths.size(); ++i) {
            PathItem& path = *paths[i];
            if (changes(*trim) && !std::exchange(path.is_trimmed, true))
                path.untrimmed = UntrimmedPath{path.drawing, trim, i, paths.size()};
            drawings.push_back(&path.drawing);
        }
        lottie::trim(*trim, drawings);
    }

    static bool changes(const art::Trim& trim)
    {
        return !trim.start.is_still() || !trim.end.is_still() || !trim.offset.is_still();
    }

    void round_corners(const Json& item)
    {
        const art::Channel radius = read_channel(item, "r", 0, 0, 1, reading_.time, reading_.budget);
        for (PathItem* path : modified_paths(item))
            path->drawing = with_rounded_corners(std::move(path->drawing), radius);
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
