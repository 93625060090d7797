#pragma once

#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"
#include "host/text/source.hpp"

namespace kfast::lottie {

/// Whether compositions that are used several times, or loop, and repeaters become symbols.
enum class Repeated { as_symbols, written_out };

/// Reads an animation of Lottie. What the scene will not have is added to `losses`. Throws Failure, which
/// names the file and the location, when the text is not Lottie, or asks for more than art::Budget allows.
art::Document read_lottie(const SourceText& source, art::Losses& losses,
                          Repeated repeated = Repeated::as_symbols);

}
