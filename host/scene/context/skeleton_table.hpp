#pragma once

#include "host/scene/model.hpp"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace kfast::scene {

/// A skeleton that has been read.
struct Skeleton {
    Bones bones;
    std::vector<double> regions; ///< how far each bone reaches to either side, in pixels
    bool is_valid = true;        ///< if not, what is wrong has been reported, and bones may be missing
    bool is_used = false;
};

std::optional<std::size_t> find_bone(const std::vector<Bone>& bones, std::string_view name);
std::vector<std::string_view> names_of(const std::vector<Bone>& bones);

/// The skeletons of a scene, in the order in which they are stored.
struct SkeletonTable {
    std::optional<std::size_t> find(std::string_view name) const;
    std::vector<std::string_view> names() const;
    /// Of all skeletons together.
    std::size_t bone_count() const;

    std::vector<Skeleton> entries;
};

}
