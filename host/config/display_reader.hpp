#pragma once

#include "host/config/draft.hpp"
#include "host/schema/report.hpp"
#include "host/schema/value_reader.hpp"

#include <array>
#include <cstddef>
#include <string_view>

namespace kfast::config {

/// The names of enumerators, in their order, as words of a text.
template <class E, std::size_t count>
constexpr std::array<schema::Word<E>, count> named_words(const std::array<std::string_view, count>& names)
{
    std::array<schema::Word<E>, count> words{};
    for (std::size_t i = 0; i < count; ++i)
        words[i] = {names[i], static_cast<E>(i)};
    return words;
}

/// `panel st7789`, `panel st7789 135 240 column=52 row=40 …`: what is not given is as in the controller's
/// default module. Whether it was valid; reports what is wrong.
bool read_panel(const kdl::Node& node, Draft& draft, schema::Report& report);

/// `bus spi clock=(MHz)62.5`, `bus i2c address=0x3D`. Whether it was valid; reports what is wrong.
bool read_bus(const kdl::Node& node, Draft& draft, schema::Report& report);

/// `beam galvo rate=(kHz)30 …` in place of a panel. Whether it was valid; reports what is wrong.
bool read_beam_part(const kdl::Node& node, Draft& draft, schema::Report& report);

/// Whether `board` has either a panel or a beam, and the bus for it; reports it if not.
bool check_display(const kdl::Node& board, const Draft& draft, schema::Report& report);

}
