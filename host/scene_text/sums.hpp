#pragma once

#include "host/art/animated.hpp"

namespace kfast::scene_text {

/// Whether their keys stand at the same times with the same eases, so that they go alike.
bool go_alike(const art::Channel& left, const art::Channel& right);

/// Whether sum() and product() of these are exact.
bool has_sum(const art::Channel& left, const art::Channel& right);
bool has_product(const art::Channel& left, const art::Channel& right);

/// Exact if has_sum(); otherwise goes straight between many moments.
art::Channel sum(const art::Channel& left, const art::Channel& right);
art::Channel difference(const art::Channel& left, const art::Channel& right);
/// Exact if has_product(); otherwise goes straight between many moments.
art::Channel product(const art::Channel& left, const art::Channel& right);

art::Channel scaled(art::Channel channel, double factor);
art::Channel shifted(art::Channel channel, double offset);

}
