#pragma once

#include "host/schema/value_reader.hpp"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace kfast::schema {

/// A unit that numbers of a kind are written with, as in (MHz)125.
struct QuantityUnit {
    std::string_view name;
    double factor;
};

/// What a number with a unit stands for.
struct QuantityForm {
    std::string_view noun;               ///< "a frequency"
    std::string_view example;            ///< "(MHz)125"
    std::span<const QuantityUnit> units; ///< the likeliest first
};

inline constexpr std::array frequency_units{QuantityUnit{"Hz", 1}, QuantityUnit{"kHz", 1e3},
                                            QuantityUnit{"MHz", 1e6}};
inline constexpr std::array memory_units{QuantityUnit{"KiB", 1024}, QuantityUnit{"MiB", 1024 * 1024},
                                         QuantityUnit{"B", 1}};
inline constexpr QuantityForm frequency{"a frequency", "(MHz)125", frequency_units};
inline constexpr QuantityForm memory_size{"a size of memory", "(KiB)264", memory_units};

/// As few digits as tell it, in the largest unit of which it has at least one: "(MHz)62.5"
std::string quantity_text(double quantity, const QuantityForm& form);

/// In Hz or bytes. Reports what is wrong and then returns nothing.
std::optional<double> read_quantity(const kdl::Value& value, const QuantityForm& form, Range range,
                                    Report& report);

}
