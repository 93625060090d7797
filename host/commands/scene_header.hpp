#pragma once

#include "core/size.hpp"
#include "host/scene_file.hpp"

#include <string>

namespace kfast {

/// What a scene is called where it becomes source.
struct SceneHeader {
    std::string name;   ///< of the array
    std::string source; ///< of the file it was made from
    Size panel;         ///< for which the memory is told
};

/// A header for C99 and C++ with the scene as an array, its size, the panel's, and the bytes that
/// kfast_create() must be lent for it (library/kfast.h), wherever it is compiled.
std::string header_text(const SceneHeader& header, const SceneFile& scene);

}
