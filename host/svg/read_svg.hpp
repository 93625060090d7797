#pragma once

#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"
#include "host/svg/poses/key_options.hpp"
#include "host/text/source.hpp"

#include <string>
#include <vector>

namespace kfast::svg {

/// Reads a drawing of SVG, a scene of one frame unless it is animated or has layers that are keys. What the
/// scene will not have is added to `losses`. Throws Failure, which names the file and the place, when the
/// text is none, or asks for more than art::Budget allows.
art::Document read_svg(const SourceText& source, const KeyOptions& options, art::Losses& losses);

/// Likewise. What was taken in one of several ways, with the option for another, is added to `notes`.
art::Document read_svg(const SourceText& source, const KeyOptions& options, art::Losses& losses,
                       std::vector<std::string>& notes);

/// With the usual options.
art::Document read_svg(const SourceText& source, art::Losses& losses);

}
