#pragma once

#include "host/art/prepare/prepare.hpp"
#include "host/compiler/compile.hpp"
#include "host/scene_text/scene_text.hpp"
#include "tests/host/scene_text/art_parts.hpp"

#include <doctest/doctest.h>
#include <string>
#include <utility>
#include <vector>

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

/// What stands behind the canvas and the palette.
inline std::string items_of(const std::string& text)
{
    const std::size_t palette = text.find("\npalette");
    const std::size_t begin =
        text.find("\n\n", palette == std::string::npos ? text.find("\ncanvas") : palette);
    return begin == std::string::npos ? "" : text.substr(begin + 2);
}

inline std::string written_items(std::vector<art::Node> nodes)
{
    return items_of(written(document(std::move(nodes))));
}

inline std::string loss_of(const art::Document& document)
{
    art::Losses losses;
    written(document, losses);
    return losses.empty() ? "" : losses.list().front().feature;
}

}
