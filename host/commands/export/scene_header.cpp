#include "host/commands/export/scene_header.hpp"

#include "host/text/glyph.hpp"
#include "host/words/feature_name.hpp"
#include "library/kfast.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <span>

namespace kfast {
namespace {

constexpr std::size_t bytes_in_a_line = 16;

std::string in_capitals(const std::string& name)
{
    std::string text;
    std::ranges::transform(name, std::back_inserter(text), [](char letter) {
        return letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A') : letter;
    });
    return text;
}

/// What kfast_features is to be for the scene, in the order of its members.
std::string features(const std::string& name, FeatureSet needed)
{
    std::string list;
    for (std::size_t number = 0; number < feature_count; ++number) {
        const auto feature = static_cast<Feature>(number);
        list += list.empty() ? "" : ", ";
        list += needed.has(feature) ? "&kfast_" + std::string{feature_name(feature)} : "0";
    }
    return "/* What it needs of the player, for a program that plays nothing else: kfast.h, kfast_features "
           "*/\n#define " +
           in_capitals(name) + "_FEATURES {" + list + "}\n";
}

std::string constant(const std::string& name, std::size_t value)
{
    return name + " = " + std::to_string(value);
}

std::string constants(const SceneHeader& header, const SceneFile& scene)
{
    const auto [width, height] = header.panel;
    return "enum {\n    " + constant(header.name + "_bytes", scene.bytes.size()) + ",\n    " +
           constant(header.name + "_width", static_cast<std::size_t>(width)) + ", /* of the panel */\n    " +
           constant(header.name + "_height", static_cast<std::size_t>(height)) + ",\n    " +
           constant(header.name + "_block_bytes", block_bytes(header, scene)) +
           " /* of memory to be lent: the player and what the scene needs on such a panel */\n};\n";
}

std::string line_of(std::span<const std::byte> bytes)
{
    std::string line = "   ";
    for (const std::byte byte : bytes) {
        char text[8];
        std::snprintf(text, sizeof text, " 0x%02x,", std::to_integer<unsigned>(byte));
        line += text;
    }
    return line + '\n';
}

std::string array(const std::string& name, std::span<const std::byte> bytes)
{
    std::string text = "static const unsigned char " + name + '[' + name + "_bytes] = {\n";
    for (; !bytes.empty(); bytes = bytes.subspan(std::min(bytes.size(), bytes_in_a_line)))
        text += line_of(bytes.first(std::min(bytes.size(), bytes_in_a_line)));
    return text + "};\n";
}

}

std::size_t block_bytes(const SceneHeader& header, const SceneFile& scene)
{
    return kfast_block_bytes(scene.bytes.data(), scene.bytes.size(), header.panel.width, header.panel.height);
}

std::string header_text(const SceneHeader& header, const SceneFile& scene)
{
    const std::string macro = "KFAST_SCENE_" + in_capitals(header.name) + "_H";
    return "/* " + visible(header.source) + ", written by kfast export */\n#ifndef " + macro + "\n#define " +
           macro + "\n\n" + constants(header, scene) + '\n' +
           features(header.name, scene.view.needed_features()) + '\n' + array(header.name, scene.bytes) +
           "\n#endif\n";
}

}
