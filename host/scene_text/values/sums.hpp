#pragma once

#include "host/art/animation/animated.hpp"
#include "host/art/animation/baked_drawing.hpp"
#include "host/art/budget.hpp"

#include <initializer_list>

namespace kfast::scene_text {

/// Whether their keys are at the same times with the same eases, so that they progress alike.
bool go_alike(const art::Channel& left, const art::Channel& right);

/// Whether sum() and product() of these are exact.
bool has_sum(const art::Channel& left, const art::Channel& right);
bool has_product(const art::Channel& left, const art::Channel& right);

/// Only if has_sum().
art::Channel sum(const art::Channel& left, const art::Channel& right);
/// Only if has_product().
art::Channel product(const art::Channel& left, const art::Channel& right);

/// How what is not exact is computed.
struct Sampling {
    double tolerance = 0;
    art::Budget& budget; ///< of computed points
};

/// Exact if has_sum(), and else within the tolerance.
art::Channel sum(const art::Channel& left, const art::Channel& right, const Sampling& sampling);
/// Exact if has_product(), and else within the tolerance.
art::Channel product(const art::Channel& left, const art::Channel& right, const Sampling& sampling);

/// From the first to the last key of all, with those as its critical times.
art::Baking baking_of(std::initializer_list<const art::Channel*> channels, double tolerance);

art::Channel scaled(art::Channel channel, double factor);
art::Channel shifted(art::Channel channel, double offset);

}
