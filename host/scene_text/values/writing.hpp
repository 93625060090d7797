#pragma once

#include "core/pixel/paint_style.hpp"
#include "host/art/budget.hpp"
#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"
#include "host/kdl/document.hpp"
#include "host/scene_text/values/stored_keys.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace kfast::scene_text {

/// `name` without what names of scenes must not contain, 1 to 255 bytes; `default_value` if nothing is left
/// of it.
std::string clean_name(std::string_view name, std::string_view default_value);

/// What happens at the end of a scene or a symbol.
kdl::Value loop_word(Loop loop);

/// Names that are all different.
class Names {
public:
    /// The name is never returned.
    void reserve(std::string_view name) { taken_.emplace(name); }
    /// The clean name itself, or with a number: "eye", "eye-2".
    std::string unique(std::string_view name, std::string_view default_value);

private:
    std::set<std::string, std::less<>> taken_;
    std::map<std::string, std::size_t, std::less<>> counts_; ///< the highest number given to a name
};

/// The colour as scenes store it: 8 bits a channel.
Colour stored_colour(const art::Rgb& colour, double opacity);

/// The palette of the scene that is being written. Every colour is named after what uses it first; black and
/// white have names already.
class Colours {
public:
    explicit Colours(art::Losses& losses);

    /// The word for the colour: its name, or that of the nearest one once there are too many.
    std::string word(Colour colour, std::string_view user);

    /// A node `palette`, unless it would be empty.
    std::vector<kdl::Node> nodes() const;

private:
    struct Entry {
        Colour colour;
        std::string name;
        bool is_known = false; ///< without a palette
    };
    const Entry& nearest(Colour colour) const;

    std::vector<Entry> entries_;
    Names names_;
    art::Losses& losses_;
};

/// For a fill or a line: the opacity is that of the colour, and does not change.
template <typename Paint>
std::vector<StoredKey<Colour>> paint_keys(const Paint& paint, std::int32_t length)
{
    const double opacity = paint.opacity.keys.front().value;
    return stored_keys(paint.colour, length,
                       [&](const art::Rgb& colour) { return stored_colour(colour, opacity); });
}

/// The names of a skeleton and its bones in the scene.
struct RigNames {
    std::string rig;
    std::vector<std::string> bones;
};

/// What is known of the scene while its nodes are written.
struct Writing {
    Writing(std::int32_t ticks, art::Losses& reported, art::Budget& computed)
        : length{ticks}, losses{reported}, budget{computed}, colours{reported}
    {
    }

    std::int32_t length; ///< of the scene, or of the symbol that is being written, in ticks
    art::Losses& losses;
    art::Budget& budget;
    Colours colours;
    Names object_names = {};
    std::vector<RigNames> rigs = {};
    Names symbol_names = {};
    std::vector<std::string> symbols =
        {}; ///< the names of those of the document; of those without uses, empty
};

}
