#pragma once

#include "core/math/point.hpp"
#include "host/compile/scene_file.hpp"

#include <cstddef>
#include <string>

namespace kfast {

/// What a scene is called where it becomes source.
struct SceneHeader {
    std::string name;   ///< of the array
    std::string source; ///< of the file it was made from
    Size panel;         ///< for which the memory is counted
};

/// What kfast_create() must be lent (library/kfast.h) on the header's panel.
std::size_t block_bytes(const SceneHeader& header, const SceneFile& scene);

/// A header for C99 and C++ with the scene as an array, its size, the panel's, and block_bytes(),
/// wherever it is compiled.
std::string header_text(const SceneHeader& header, const SceneFile& scene);

}
