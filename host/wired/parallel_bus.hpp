#pragma once

#include "firmware/panel/bus.hpp"
#include "host/wired/panel_lines.hpp"

#include <cstddef>
#include <span>

namespace kfast {

/// A display on an 8080 bus of eight bits, made of GPIO lines: two calls of the kernel for each byte. The
/// data is taken when WR rises. The display's RD is to be wired high. Everything has been sent when a call
/// returns.
class ParallelBus {
public:
    /// `lines`, which have D/C, WR and all of the data, must outlive the bus.
    explicit ParallelBus(PanelLines& lines) : lines_{lines} {}

    void command(std::span<const std::byte> bytes) { send(bytes, 0); }
    void parameters(std::span<const std::byte> bytes) { send(bytes, line_bit(LineRole::dc)); }
    void start_data(std::span<const std::byte> bytes) { parameters(bytes); }
    bool busy() const { return false; }

private:
    static_assert(line_bit(LineRole::data0) == 1 && line_bit(LineRole::data7) == 0x80, "as in a byte");

    void send(std::span<const std::byte> bytes, std::uint32_t dc)
    {
        constexpr std::uint32_t write = line_bit(LineRole::write);
        constexpr std::uint32_t all = 0xFF | write | line_bit(LineRole::dc) | line_bit(LineRole::select);
        for (const std::byte byte : bytes) {
            lines_.set(all, std::to_integer<std::uint32_t>(byte) | dc);
            lines_.set(write, write);
        }
        lines_.set(LineRole::select, true);
    }

    PanelLines& lines_;
};

static_assert(DisplayBus<ParallelBus>);

}
