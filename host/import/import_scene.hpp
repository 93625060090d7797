#pragma once

#include "host/art/losses.hpp"
#include "host/compiler/compile.hpp"
#include "host/import/extent.hpp"
#include "host/import/options.hpp"
#include "host/text/source.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kfast::importing {

/// The limit of compressed content once it is unpacked.
inline constexpr std::size_t max_unpacked_bytes = std::size_t{16} << 20;

struct Imported {
    std::string text;       ///< a scene, as docs/scene-language.md has it
    CompiledScene compiled; ///< the text, which compiles without errors and warnings
    Extent extent;
    art::Losses losses;
    std::vector<std::string> notes; ///< what was read in one of several ways, and how to choose another
};

/// Makes a scene of the content of another program's file: Lottie (JSON, or dotLottie's zip), SVG or Synfig
/// (XML, or gzip of it). Throws Failure, which names the file, when the content is damaged, none of these, or
/// more than art::Budget or a scene allows.
Imported import_scene(const std::string& name, std::string content, const Options& options);

/// Makes a scene of drawings that are the same picture at several times; see svg::read_svg_keys(). They may
/// be packed by gzip.
Imported import_key_drawings(std::vector<SourceText> drawings, std::span<const double> times,
                             const Options& options);

}
