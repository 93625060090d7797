#pragma once

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

}
