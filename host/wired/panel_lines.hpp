#pragma once

#include "host/gpio/gpio_outputs.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace kfast {

/// What a GPIO line is wired to on a display.
enum class LineRole {
    data0,
    data1,
    data2,
    data3,
    data4,
    data5,
    data6,
    data7,
    write,
    dc,
    select,
    reset,
    backlight
};

/// In the order of LineRole.
inline constexpr std::array<std::string_view, 13> line_role_names{
    "data0", "data1", "data2", "data3",  "data4", "data5",     "data6",
    "data7", "wr",    "dc",    "select", "reset", "backlight",
};

constexpr std::string_view line_role_name(LineRole role)
{
    return line_role_names[static_cast<std::size_t>(role)];
}

/// Names as in GpioLine::name.
using LineNames = std::map<LineRole, std::string>;

/// A bit for each role.
constexpr std::uint32_t line_bit(LineRole role) { return std::uint32_t{1} << static_cast<unsigned>(role); }

/// The GPIO lines of a display. Initially the display is dark, not selected, and not in
/// reset.
class PanelLines {
public:
    /// `lines` are of one chip, and at least one. Throws Failure as GpioOutputs does.
    PanelLines(const std::string& chip, const LineNames& lines);

    bool has(LineRole role) const { return (roles_ & line_bit(role)) != 0; }

    /// Bits are those of line_bit(): the lines in `which` are set to their bits of `levels`; those that are
    /// not wired do not matter. Costs a kernel call if anything changes. Throws Failure as GpioOutputs
    /// does.
    void set(std::uint32_t which, std::uint32_t levels);
    void set(LineRole role, bool level) { set(line_bit(role), level ? line_bit(role) : 0); }

private:
    std::uint32_t roles_;
    std::uint32_t levels_;
    GpioOutputs outputs_;
};

}
