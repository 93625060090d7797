#pragma once

#include "firmware/settings/board_settings.hpp"
#include "host/picture/panel_choice.hpp"
#include "host/wired/panel_lines.hpp"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>

namespace kfast {

/// A display that is wired to this computer, as chosen by options.
struct WiredPanelOptions {
    const PanelChoice* panel = nullptr;
    std::optional<Size> glass;
    std::optional<int> column;
    std::optional<int> row;
    int degrees = 0; ///< of rotation
    std::optional<bool> bgr;
    std::optional<bool> inverted;
    std::uint8_t brightness = 255;

    BusKind bus = BusKind::spi;
    std::string spi;
    int spi_mode = 0;
    std::optional<std::uint32_t> clock; ///< Hz, of SPI
    std::string chip;
    LineNames lines;
};

/// Adds these options to `app`. `options` must outlive its parsing.
void declare_wired_panel_options(CLI::App& app, WiredPanelOptions& options);

/// Only panel, bus and its clock are filled in. Throws CLI::ValidationError for what the display cannot do,
/// and for wires that are missing or too many.
BoardSettings chosen_wired_panel(const WiredPanelOptions& options);

}
