#include "host/config/printed_roles.hpp"

#include <algorithm>
#include <array>

namespace kfast::config {
namespace {

struct PrintedName {
    std::string_view name;
    PinRole role;
};

constexpr std::array printed_names{
    PrintedName{"sck", PinRole::clock},     PrintedName{"scl", PinRole::clock},
    PrintedName{"sclk", PinRole::clock},    PrintedName{"clk", PinRole::clock},
    PrintedName{"wr", PinRole::clock},      PrintedName{"mosi", PinRole::data},
    PrintedName{"sda", PinRole::data},      PrintedName{"sdi", PinRole::data},
    PrintedName{"din", PinRole::data},      PrintedName{"tx", PinRole::data},
    PrintedName{"d0", PinRole::data},       PrintedName{"cs", PinRole::select},
    PrintedName{"ce", PinRole::select},     PrintedName{"rs", PinRole::dc},
    PrintedName{"a0", PinRole::dc},         PrintedName{"rst", PinRole::reset},
    PrintedName{"res", PinRole::reset},     PrintedName{"bl", PinRole::backlight},
    PrintedName{"blk", PinRole::backlight}, PrintedName{"led", PinRole::backlight},
    PrintedName{"te", PinRole::tearing},    PrintedName{"uart", PinRole::log},
    PrintedName{"z", PinRole::blank},       PrintedName{"load", PinRole::ldac},
};

}

std::optional<PinRole> role_printed_as(std::string_view name)
{
    const auto printed = std::ranges::find(printed_names, name, &PrintedName::name);
    return printed == printed_names.end() ? std::nullopt : std::optional{printed->role};
}

}
