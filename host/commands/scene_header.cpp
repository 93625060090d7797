#include "host/commands/scene_header.hpp"

#include "host/text/glyph.hpp"
#include "library/kfast.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <span>

namespace kfast {
namespace {

constexpr std::size_t bytes_in_a_line = 16;

std::string guard(const std::string& name)
{
    std::string text = "KFAST_SCENE_";
    std::ranges::transform(name, std::back_inserter(text), [](char letter) {
        return letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A') : letter;
    });
    return text + "_H";
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
    const std::string macro = guard(header.name);
    return "/* " + visible(header.source) + ", written by kfast export */\n#ifndef " + macro + "\n#define " +
           macro + "\n\n" + constants(header, scene) + '\n' + array(header.name, scene.bytes) + "\n#endif\n";
}

}
