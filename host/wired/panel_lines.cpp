#include "host/wired/panel_lines.hpp"

#include <vector>

namespace kfast {
namespace {

constexpr std::uint32_t levels_at_rest =
    line_bit(LineRole::write) | line_bit(LineRole::select) | line_bit(LineRole::reset);

std::uint32_t roles_of(const LineNames& lines)
{
    std::uint32_t roles = 0;
    for (const auto& [role, line] : lines)
        roles |= line_bit(role);
    return roles;
}

std::vector<GpioLine> at_rest(const LineNames& lines)
{
    std::vector<GpioLine> all;
    for (const auto& [role, line] : lines)
        all.push_back({line, (levels_at_rest & line_bit(role)) != 0});
    return all;
}

/// Those bits of `bits` that `roles` has, without gaps: lines are counted in the order of their roles.
std::uint32_t packed(std::uint32_t bits, std::uint32_t roles)
{
    std::uint32_t lines = 0;
    for (unsigned line = 0; roles != 0; roles &= roles - 1, ++line)
        if ((bits & roles & ~(roles - 1)) != 0)
            lines |= std::uint32_t{1} << line;
    return lines;
}

}

PanelLines::PanelLines(const std::string& chip, const LineNames& lines)
    : roles_{roles_of(lines)}, levels_{levels_at_rest}, outputs_{chip, at_rest(lines)}
{
}

void PanelLines::set(std::uint32_t which, std::uint32_t levels)
{
    const std::uint32_t changed = (levels_ ^ levels) & which & roles_;
    if (changed == 0)
        return;
    outputs_.set(packed(changed, roles_), packed(levels, roles_));
    levels_ ^= changed;
}

}
