#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace kfast::scene_text {

/// `name` without what names of scenes must not hold, 1 to 255 bytes; `default_value` if nothing is left of
/// it.
std::string clean_name(std::string_view name, std::string_view default_value);

/// Names that are all different.
class Names {
public:
    /// Never given out.
    void reserve(std::string_view name) { taken_.emplace(name); }
    /// The clean name itself, or with a number: "eye", "eye-2".
    std::string unique(std::string_view name, std::string_view default_value);

private:
    std::set<std::string, std::less<>> taken_;
    std::map<std::string, std::size_t, std::less<>> counts_; ///< the highest number given to a name
};

}
