#pragma once

#include "host/compiler/compile.hpp"

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace kfast::test {

/// The bytes of a scene that must compile.
inline std::vector<std::byte> compiled(std::string_view text)
{
    Diagnostics diagnostics;
    const SourceText source{"test.kfast", std::string{text}};
    const auto bytes = compile(source, diagnostics);
    if (!bytes)
        throw std::runtime_error{format(diagnostics.sorted().front(), source)};
    return *bytes;
}

}
