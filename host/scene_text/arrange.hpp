#pragma once

#include "host/art/document.hpp"
#include "host/art/losses.hpp"

namespace kfast::scene_text {

/// Throws Failure if a number of the document is infinite or none.
void check_finite(const art::Document& document);

/// Brings the nodes into a form of which each is one item of a scene.
void arrange(art::Document& document, double tolerance, art::Losses& losses);

}
