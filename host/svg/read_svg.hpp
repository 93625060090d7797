#pragma once

#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"
#include "host/svg/poses/key_options.hpp"
#include "host/text/source.hpp"

#include <span>
#include <string>
#include <vector>

namespace kfast::svg {

/// Reads a drawing of SVG, a scene of one frame unless it is animated or has layers that are keys. What the
/// scene will not have is added to `losses`. Throws Failure, which names the file and the location, when the
/// text is no SVG, or asks for more than art::Budget allows.
art::Document read_svg(const SourceText& source, const KeyOptions& options, art::Losses& losses);

/// The same. What was read in one of several ways, with the option for another, is added to `notes`.
art::Document read_svg(const SourceText& source, const KeyOptions& options, art::Losses& losses,
                       std::vector<std::string>& notes);

/// The same with the default options.
art::Document read_svg(const SourceText& source, art::Losses& losses);

/// Reads drawings that are the same picture at several times, each a file of its own. What is the same in all
/// of them is found by its id, else by its label, else by its order among its kind, always within what is the
/// same group. It is one shape of the scene, named as in the first drawing that has it, and changes from key
/// to key; what is missing in a drawing is not visible from there until the next drawing that has it. The
/// canvas is that of the first drawing.
///
/// `times` are frames, one for each drawing; the first is 0 or more, and they rise. Throws Failure, which
/// names the file and the location, when a text is no drawing, when there are not as many times as drawings
/// or when they do not rise, or when more is asked for than art::Budget allows. How to match other parts
/// (part_match.hpp) is added to `notes`.
art::Document read_svg_keys(std::span<const SourceText> drawings, std::span<const double> times,
                            const KeyOptions& options, art::Losses& losses, std::vector<std::string>& notes);

}
