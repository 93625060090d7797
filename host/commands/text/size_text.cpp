#include "host/commands/text/size_text.hpp"

#include "core/player.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
#include <string_view>

namespace kfast {
namespace {

/// A side of a panel, and what follows it; 0 for anything else.
int read_side(std::string_view& text)
{
    int side = 0;
    const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), side);
    text.remove_prefix(static_cast<std::size_t>(rest - text.data()));
    return error == std::errc{} && side >= 1 && side <= Player::max_panel ? side : 0;
}

}

Size read_size(const std::string& option, const std::string& text)
{
    std::string_view rest = text;
    Size size{read_side(rest), 0};
    if (rest.starts_with('x')) {
        rest.remove_prefix(1);
        size.height = read_side(rest);
    }
    if (size.width == 0 || size.height == 0 || !rest.empty())
        throw CLI::ValidationError(option, "'" + text +
                                               "' is no size: write it like 240x135, with sides of 1 to " +
                                               std::to_string(Player::max_panel));
    return size;
}

std::string size_text(Size size) { return std::to_string(size.width) + 'x' + std::to_string(size.height); }

}
