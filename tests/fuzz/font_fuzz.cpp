#include "core/scene/scene_view.hpp"
#include "host/compiler/compile.hpp"
#include "host/program/failure.hpp"
#include "host/scene/font/outline_font.hpp"
#include "host/scene/font/text_layout.hpp"
#include "host/text/characters.hpp"
#include "host/text/diagnostic.hpp"
#include "host/text/source.hpp"
#include "tests/demand.hpp"
#include "tests/fuzz/played.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <span>
#include <string>
#include <sys/mman.h>
#include <unistd.h>

using namespace kfast;
using namespace kfast::test;

namespace {

constexpr std::size_t most_letters = 6;

bool is_finite(scene::Vec2 spot) { return std::isfinite(spot.x) && std::isfinite(spot.y); }

void check_outline(const scene::Outline& outline)
{
    demand(outline.closed && is_finite(outline.from));
    for (const scene::Curve& curve : outline.curves)
        demand(is_finite(curve.c1) && is_finite(curve.c2) && is_finite(curve.to));
}

/// Some of the characters that the font has.
std::u32string characters_of(scene::Font& font)
{
    std::u32string found;
    for (char32_t character = U' '; character < 0x180 && found.size() < most_letters; ++character) {
        const scene::Letter* const letter = is_printable(character) ? font.letter(character) : nullptr;
        if (letter == nullptr)
            continue;
        demand(std::isfinite(letter->advance));
        std::ranges::for_each(letter->outlines, check_outline);
        found += character;
    }
    return found;
}

/// Every character, and a second line of them.
void set(scene::Font& font, const std::u32string& characters)
{
    std::string text;
    for (const char32_t character : characters)
        append_utf8(text, character);
    const scene::TextStyle style{
        .font = &font, .at = {10, 20}, .size = 16, .align = Align::center, .leading = 20};
    const auto outlines = set_text(text + '\n' + text, style, 100'000);
    if (outlines)
        std::ranges::for_each(*outlines, check_outline);
}

/// As a text of KDL says them.
std::string escaped(const std::u32string& characters)
{
    std::string text;
    for (const char32_t character : characters) {
        std::array<char, 16> escape{};
        std::snprintf(escape.data(), escape.size(), "\\u{%x}", static_cast<unsigned>(character));
        text += escape.data();
    }
    return text;
}

/// A file in memory, and the folder that it is in.
class FontFile {
public:
    FontFile() : descriptor_{::memfd_create("font", MFD_CLOEXEC)} { demand(descriptor_ >= 0); }

    void hold(std::span<const std::uint8_t> bytes) const
    {
        demand(::ftruncate(descriptor_, 0) == 0);
        demand(::pwrite(descriptor_, bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size()));
    }
    std::string folder() const { return "/proc/self/fd"; }
    std::string name() const { return "./" + std::to_string(descriptor_); }

private:
    int descriptor_;
};

std::string scene_with(const std::string& words, const std::string& font)
{
    const std::string style = "at=\"10,20\" size=16 font=\"" + font + "\"";
    return "kfast 1\ncanvas 64 48 frames=2\n"
           "object still fill=yellow { text \"" +
           words + "\\n" + words + "\" " + style + " align=right }\n" + "input words kind=text glyphs=\"" +
           words + "\" max=3\nobject label fill=red { text input=words " + style + " }\n";
}

void compile_and_play(const std::u32string& characters, const FontFile& file)
{
    const SourceText source{
        .name = "fuzz", .text = scene_with(escaped(characters), file.name()), .folder = file.folder()};
    Diagnostics diagnostics;
    const auto compiled = compile(source, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.sorted())
        demand(!format(diagnostic, source).empty());
    demand(compiled.has_value() != diagnostics.has_errors());
    if (!compiled)
        return;
    demand(static_cast<bool>(SceneView::parse(*compiled)));
    play(*compiled);
}

std::u32string characters_in(std::span<const std::uint8_t> bytes)
{
    try {
        scene::OutlineFont font{std::string(bytes.begin(), bytes.end())};
        demand(font.units_per_em() > 0);
        std::u32string characters = characters_of(font);
        set(font, characters);
        return characters;
    } catch (const Failure& failure) {
        demand(failure.what()[0] != '\0');
        return U"A";
    }
}

}

/// Any bytes at all: they are no font, which is told, or have letters that can be set, compiled and played.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const FontFile file;
    const std::span bytes{data, size};
    file.hold(bytes);
    compile_and_play(characters_in(bytes), file);
    return 0;
}
