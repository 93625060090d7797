#pragma once

#include <span>
#include <string_view>

namespace kfast::scene {

/// A font that is part of this program, in the format that HersheyFont reads.
struct HersheyFace {
    std::string_view name;
    std::string_view jhf;
};

std::span<const HersheyFace> hershey_faces();

}
