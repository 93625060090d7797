#pragma once

#include "core/pixel/paint_style.hpp"
#include "host/text/source.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kfast::scene {

/// The colour of that name in CSS (host/scene/context/colour_names.hpp).
std::optional<Colour> known_colour(std::string_view name);
std::vector<std::string_view> known_colour_names();

/// "#rgb" or "#rrggbb", or with opacity "#rgba" or "#rrggbbaa".
std::optional<Colour> hex_colour(std::string_view text);

/// The colours a scene names, and those it uses.
class Palette {
public:
    /// Returns the location of an earlier declaration of that name, if there is one; then nothing is changed.
    std::optional<SourceSpan> declare(const std::string& name, Colour colour, SourceSpan place);
    std::size_t declared() const { return named_.size(); }

    /// A declared name, a known name or a hexadecimal colour.
    std::optional<Colour> find(const std::string& text) const;
    /// The index of the colour among those in use; nothing when max_colours are in use already.
    std::optional<std::size_t> use(Colour colour);

    /// Uses all declared ones. Returns false if there would be more than max_colours in use.
    bool use_declared();
    /// Whether the palette names the colour with this index among those in use.
    bool is_declared(std::size_t index) const;
    /// Of the colours in use, the one that is declared `steps` behind that with this index, from the last on
    /// to the first; itself if it is not declared. All declared ones are in use.
    std::size_t behind(std::size_t index, int steps) const;

    /// All names that find() knows, the declared ones first.
    std::vector<std::string_view> names() const;
    /// The declared ones, and of the others those that were in the first version of CSS.
    std::vector<std::string_view> common_names() const;
    /// Each once, in the order of their first use.
    const std::vector<Colour>& used() const { return used_; }

private:
    std::vector<std::string_view> declared_names() const;

    struct Named {
        Colour colour;
        SourceSpan place;
    };
    std::map<std::string, Named> named_;
    std::vector<Colour> in_order_; ///< those of named_, in the order of their declaration
    std::vector<Colour> used_;
};

}
