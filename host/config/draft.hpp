#pragma once

#include "firmware/settings/board_settings.hpp"
#include "host/kdl/document.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace kfast::config {

/// Settings while their text is read, and the nodes that they came from; those live as long as the document.
struct Draft {
    BoardSettings settings;
    std::optional<std::uint32_t> clock; ///< without it, by what the display is rated for
    std::optional<bool> tearing;        ///< without it, by whether there is a pin for it
    std::size_t controls = 0;           ///< of settings.controls

    const kdl::Node* panel = nullptr;
    const kdl::Node* beam = nullptr;
    const kdl::Node* bus = nullptr;
    const kdl::Node* pins = nullptr;
    std::array<const kdl::Node*, BoardSettings::max_controls> control_nodes{};
};

}
