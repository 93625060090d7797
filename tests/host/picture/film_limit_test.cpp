#include "host/picture/apng.hpp"
#include "host/picture/gif.hpp"
#include "host/picture/svg.hpp"

#include "tests/compiled.hpp"
#include "tests/host/picture/painted_source.hpp"
#include "tests/temporary_folder.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

constexpr FilmLimit one_mebibyte{1};

std::string refused(const std::string& what)
{
    return "the " + what +
           " would be larger than 1 MiB: play less with --clip, choose a smaller --scale or --size, or make "
           "an .mp4";
}

/// 500 lines, which are somewhere else in each frame.
std::string many_lines()
{
    std::string text =
        "kfast 1\ncanvas 200 200 frames=100\nobject o stroke=white { track x { at 0 0; at 100 90 }\n";
    for (int i = 0; i < 500; ++i)
        text += "line 0 " + std::to_string(i % 200) + " 99 " + std::to_string(i / 3) + '\n';
    return text + "}\n";
}

Timeline frames(int count) { return {30000, {{}, Time::frame(count), Loop::repeat}}; }

/// Colours that do not get smaller by packing.
int noise(int frame, int x, int y)
{
    std::uint32_t word = static_cast<std::uint32_t>((frame * 257 + x) * 257 + y) * 2654435761U;
    word = (word ^ word >> 15) * 2246822519U;
    return static_cast<int>((word ^ word >> 13) & 0xFFFF);
}

template <class Write>
std::string failure_text(Write write)
{
    const TemporaryFolder folder;
    const std::filesystem::path target = folder / "film";
    std::string reason;
    try {
        write(target);
    } catch (const Failure& failure) {
        reason = failure.what();
    }
    CHECK(folder.entries() == (reason.empty() ? 1 : 0));
    return reason;
}

std::string gif_failure(int count)
{
    PaintedSource source{{256, 256}, noise};
    return failure_text(
        [&](const auto& target) { write_gif(target, source, frames(count), ignore_progress, one_mebibyte); });
}

std::string apng_failure(int count)
{
    PaintedSource source{{256, 256}, noise};
    return failure_text([&](const auto& target) {
        write_apng(target, source, frames(count), ignore_progress, one_mebibyte);
    });
}

std::string svg_failure(int count)
{
    const std::vector<std::byte> scene = compiled(many_lines());
    SvgSource source{*SceneView::parse(scene), {200, 200}, Fit::contain};
    return failure_text([&](const auto& target) {
        write_animated_svg(target, source, frames(count), ignore_progress, one_mebibyte);
    });
}

}

TEST_CASE("a film that becomes too large is refused, and leaves no file")
{
    CHECK(gif_failure(5).empty());
    CHECK(gif_failure(30) == refused("GIF"));
    CHECK(apng_failure(5).empty());
    CHECK(apng_failure(30) == refused("animated PNG"));
    CHECK(svg_failure(5).empty());
    CHECK(svg_failure(100) == refused("SVG"));
}

}
