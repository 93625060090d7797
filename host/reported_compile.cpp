#include "host/reported_compile.hpp"

#include "host/compiler/compile.hpp"
#include "host/reported_diagnostics.hpp"

namespace kfast {

CompiledText compile_and_report(const SourceText& source, std::ostream& out)
{
    Diagnostics diagnostics;
    auto compiled = compile_with_names(source, diagnostics);
    const auto [errors, warnings] = report(diagnostics, source, out);
    if (!compiled)
        return {std::nullopt, {}, errors, warnings};
    return {std::move(compiled->bytes), std::move(compiled->item_names), errors, warnings};
}

}
