#include "host/reported_compile.hpp"

#include "host/compiler/compile.hpp"
#include "host/reported_diagnostics.hpp"

namespace kfast {

CompiledText compile_and_report(const SourceText& source)
{
    Diagnostics diagnostics;
    std::optional<std::vector<std::byte>> bytes = compile(source, diagnostics);
    const auto [errors, warnings] = report(diagnostics, source);
    return {std::move(bytes), errors, warnings};
}

}
