#pragma once

#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"
#include "host/text/source.hpp"

namespace kfast::synfig {

/// Reads an animation of Synfig. What the scene will not have is added to `losses`. Throws Failure, which
/// names the file and the location, when the text is not Synfig, or asks for more than art::Budget allows.
art::Document read_synfig(const SourceText& source, art::Losses& losses);

}
