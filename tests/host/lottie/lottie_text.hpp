#pragma once

#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"
#include "host/lottie/read_lottie.hpp"

#include <string>

namespace kfast::lottie {

/// Of an animation of 100 by 80 pixels with 60 frames, 30 each second: the layers as they stand in the list,
/// the uppermost first. `more` are members beside them, with a comma behind.
std::string animation_text(const std::string& layers, const std::string& more = "");

/// Reads it, and fails the test if something is lost.
art::Document read_whole(const std::string& text);
art::Document read_with(const std::string& text, art::Losses& losses);
/// Without symbols.
art::Document read_written_out(const std::string& text);

/// The message of the Failure; empty if there is none.
std::string failure_of(const std::string& text, Repeated repeated = Repeated::as_symbols);

/// A layer with a solid of 20 by 10 pixels; `more` are members with a comma behind.
std::string solid(const std::string& more, const char* name = "box");

const art::Group& group_of(const art::Node& node);
const art::Shape& shape_of(const art::Node& node);

}
