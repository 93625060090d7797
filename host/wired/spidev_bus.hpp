#pragma once

#include "firmware/panel/bus.hpp"
#include "host/wired/panel_lines.hpp"
#include "host/wired/spi_device.hpp"

#include <cstddef>
#include <span>

namespace kfast {

/// A display on spidev; D/C is a GPIO line, and so is chip select if it is among the lines. Everything has
/// been sent when a call returns.
class SpidevBus {
public:
    /// `spi` and `lines`, which have D/C, must outlive the bus.
    SpidevBus(SpiDevice& spi, PanelLines& lines) : spi_{spi}, lines_{lines} {}

    void command(std::span<const std::byte> bytes) { send(bytes, 0); }
    void parameters(std::span<const std::byte> bytes) { send(bytes, line_bit(LineRole::dc)); }
    void start_data(std::span<const std::byte> bytes) { parameters(bytes); }
    bool busy() const { return false; }

private:
    void send(std::span<const std::byte> bytes, std::uint32_t dc)
    {
        lines_.set(line_bit(LineRole::dc) | line_bit(LineRole::select), dc);
        spi_.write(bytes);
        lines_.set(LineRole::select, true);
    }

    SpiDevice& spi_;
    PanelLines& lines_;
};

static_assert(DisplayBus<SpidevBus>);

}
