#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <vector>

namespace kfast::test {

inline std::vector<std::byte> bytes(std::initializer_list<int> values)
{
    std::vector<std::byte> result(values.size());
    std::ranges::transform(values, result.begin(), [](int value) { return static_cast<std::byte>(value); });
    return result;
}

}
