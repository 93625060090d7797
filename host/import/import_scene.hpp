#pragma once

#include "core/size.hpp"
#include "host/art/losses.hpp"
#include "host/art/prepare.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace kfast::importing {

struct Options {
    double tolerance = art::usual_tolerance; ///< canvas pixels
    std::optional<Size> size;                ///< of the canvas: the art is scaled to lie within it
};

struct Imported {
    std::string text; ///< a scene, as docs/scene-language.md has it
    art::Losses losses;
};

/// Whether the content of a file is, by its first bytes, of a kind that can be imported.
bool can_import(std::string_view content);

/// Makes a scene of the content of another program's file: Lottie (JSON, or dotLottie's zip), SVG or Synfig
/// (XML, or gzip of it). Throws Failure, which names the file, when the content is damaged, none of these, or
/// more than art::Budget allows.
Imported import_scene(const std::string& name, std::string content, const Options& options);

}
