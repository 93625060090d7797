#pragma once

#include "host/preview/controls/preview_key.hpp"

#include <cstddef>
#include <optional>
#include <set>
#include <string>

namespace kfast {

/// What a preview shows besides the picture.
struct ViewOptions {
    bool onion_skin = false;    ///< the key frames before and after, faintly
    bool bones = false;         ///< skeletons and backbones
    bool numbers = false;       ///< points and strokes of the selected object, or of all, after equalization
    bool changed_areas = false; ///< what a board would send for this picture
    bool panel_frame = false;   ///< the edge of the module around the picture
    bool fit_report = false;    ///< memory and speed on a board, in the panel at the side
    bool time_line = true;
    int zoom = 0;             ///< window pixels per panel pixel, up to largest_zoom; 0: as large as fits
    bool board_speed = false; ///< play as slowly as the board would
    /// The number of an item in SceneFile::item_names; none is selected at first.
    std::optional<std::size_t> selected = {};
    /// Items whose keys are on the time line by quantity, in rows of their own: their numbers, as above.
    std::set<std::size_t> unfolded = {};
};

/// Turns on or off, or zooms, what `key` means; does nothing for other keys.
void press(ViewOptions& view, PreviewKey key);

/// What differs from the defaults, as "  onion skin  no time line  zoom 2"; nothing about what is selected.
std::string in_words(const ViewOptions& view);

}
