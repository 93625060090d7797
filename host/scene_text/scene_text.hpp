#pragma once

#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"
#include "host/scene_text/values/reach.hpp"

#include <string>
#include <string_view>

namespace kfast::scene_text {

struct SceneText {
    std::string text;
    Reach reach; ///< of what was written
};

/// The scene as a text that a person can read and go on editing, and that compiles without errors or
/// warnings. `origin` says what it was made from, for the comment at its beginning. What the language cannot
/// express is replaced by what looks most like it, within `tolerance` pixels where that is possible at all,
/// and added to `losses` where it is not. Throws Failure where a limit of scenes is exceeded
/// (docs/scene-language.md, "Limits").
SceneText scene_text(const art::Document& document, std::string_view origin, double tolerance,
                     art::Losses& losses);

}
