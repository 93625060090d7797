#pragma once

#include "host/art/losses.hpp"
#include "host/text/diagnostic.hpp"

#include <span>
#include <string>

namespace kfast {

/// What has been found in a file.
struct CheckedFile {
    std::string name;
    std::string text; ///< that `diagnostics` are about
    Diagnostics diagnostics = {};
    art::Losses losses = {};  ///< of a file of another program
    std::string failure = {}; ///< why it could not be read at all
    std::string summary = {}; ///< of a good one: "2 objects, …"

    bool is_valid() const { return failure.empty() && !diagnostics.has_errors(); }
};

/// For editors: an object whose form docs/editors.md describes.
std::string check_json(std::span<const CheckedFile> files);

}
