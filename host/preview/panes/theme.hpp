#pragma once

#include "core/pixel/paint_style.hpp"
#include "host/preview/overlay/overlay.hpp"

/// The colours of the preview's window.
namespace kfast::theme {

constexpr Colour faint(Colour colour, std::uint8_t opacity)
{
    colour.opacity = opacity;
    return colour;
}

inline constexpr Colour backdrop{22, 24, 29}; ///< around the picture
inline constexpr Colour surface{32, 35, 42};  ///< of panes
inline constexpr Colour lane{38, 42, 50};     ///< every other row
inline constexpr Colour selected{48, 64, 88};
inline constexpr Colour border{52, 57, 67};
inline constexpr Colour track{55, 60, 71}; ///< of bars: their empty part
inline constexpr Colour shade{12, 13, 16, 225};

inline constexpr Colour text{214, 218, 226};
inline constexpr Colour quiet_text{142, 150, 165};
inline constexpr Colour heading{111, 180, 255};
inline constexpr Colour good{134, 207, 142};
inline constexpr Colour bad{242, 119, 122};

inline constexpr Colour accent{82, 156, 235};
inline constexpr Colour clip{58, 92, 136};
inline constexpr Colour playing_clip{74, 128, 196};
inline constexpr Colour key{229, 192, 123};
inline constexpr Colour event{134, 207, 142};
inline constexpr Colour play_head{255, 122, 92};
inline constexpr Colour pixel_grid{128, 134, 146, 70};

inline constexpr Colour glass{8, 9, 11};
inline constexpr Colour module{24, 58, 74};
inline constexpr Colour module_edge{58, 108, 130};
inline constexpr Colour solder{201, 176, 115};

constexpr Colour mark(MarkKind kind)
{
    switch (kind) {
    case MarkKind::bone:
        return {255, 176, 84};
    case MarkKind::backbone:
        return {240, 128, 214};
    case MarkKind::outline:
        return {92, 214, 255};
    case MarkKind::control:
        return {150, 158, 175};
    case MarkKind::point:
        return {255, 226, 110};
    case MarkKind::stroke:
        return {150, 240, 160};
    case MarkKind::changed_area:
        return {255, 96, 96};
    }
    return text;
}

}
