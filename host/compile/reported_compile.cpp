#include "host/compile/reported_compile.hpp"

#include "host/compiler/compile.hpp"

namespace kfast {

CompiledText compile_and_report(const SourceText& source, const Reporter& reporter)
{
    Diagnostics diagnostics;
    auto compiled = compile_with_names(source, diagnostics);
    const auto [errors, warnings] = reporter(diagnostics, source);
    if (!compiled)
        return {std::nullopt, {}, {}, {}, errors, warnings};
    return {std::move(compiled->bytes),
            std::move(compiled->item_names),
            std::move(compiled->item_places),
            std::move(compiled->other_names),
            errors,
            warnings};
}

}
