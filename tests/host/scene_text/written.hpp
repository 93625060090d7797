#pragma once

#include "host/art/prepare/prepare.hpp"
#include "host/compiler/compile.hpp"
#include "host/scene_text/scene_text.hpp"

#include <doctest/doctest.h>
#include <string>

namespace kfast::test {

/// Everything that the compiler says of a text; nothing if it is good.
inline std::string findings_in(const std::string& text)
{
    Diagnostics diagnostics;
    const SourceText source{"scene.kfast", text};
    compile(source, diagnostics);
    std::string findings;
    for (const Diagnostic& diagnostic : diagnostics.sorted())
        findings += format(diagnostic, source);
    return findings;
}

/// The text of a document, which compiles without errors and warnings.
inline std::string written(const art::Document& document, art::Losses& losses)
{
    std::string text = scene_text::scene_text(document, "test.json", art::default_tolerance, losses).text;
    INFO(text);
    CHECK(findings_in(text) == "");
    return text;
}

/// Likewise, and nothing is lost.
inline std::string written(const art::Document& document)
{
    art::Losses losses;
    std::string text = written(document, losses);
    CHECK(losses.empty());
    return text;
}

}
