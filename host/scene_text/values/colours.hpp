#pragma once

#include "core/pixel/paint_style.hpp"
#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"
#include "host/kdl/document.hpp"
#include "host/scene_text/values/names.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace kfast::scene_text {

/// As scenes store it: 8 bits a channel.
Colour stored_colour(const art::Rgb& colour, double opacity);

/// The palette of the scene that is being written. Every colour has a name from what has it first; black and
/// white have theirs already.
class Colours {
public:
    explicit Colours(art::Losses& losses);

    /// What the colour is written as: the name of it, or of the nearest one once there are too many.
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

}
