#pragma once

#include <span>
#include <string_view>

namespace kfast::config {

/// Settings that are part of this program: a file of boards/pico/configurations.
struct Configuration {
    std::string_view name;
    std::string_view text;
};

std::span<const Configuration> configurations();

}
