#include "firmware/run/run.hpp"

#include "tests/compiled.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <optional>
#include <random>
#include <string>
#include <vector>

/// Scenes that are as large as anybody may write them: memory around what the board lends stays as it was,
/// and the panel shows what a full redraw would.
namespace kfast::test {
namespace {

using Bytes = std::vector<std::byte>;

constexpr Size panel_size{96, 64};
constexpr std::size_t guard = 64;
constexpr std::byte mark{0xA5};

/// Memory with a guard on either side.
class Guarded {
public:
    explicit Guarded(std::size_t size) : memory_(size + 2 * guard, mark) {}

    std::span<std::byte> inside() { return std::span{memory_}.subspan(guard, memory_.size() - 2 * guard); }
    bool guards_hold() const
    {
        const std::span all{memory_};
        return is_marked(all.first(guard)) && is_marked(all.last(guard));
    }
    bool is_untouched() const { return is_marked(memory_); }

private:
    static bool is_marked(std::span<const std::byte> part)
    {
        return std::ranges::all_of(part, [](std::byte byte) { return byte == mark; });
    }

    Bytes memory_;
};

/// A panel that takes everything at once.
class QuickPanel {
public:
    static constexpr PixelFormat format = PixelFormat::rgb565_be;
    static constexpr Size granularity{.width = 1, .height = 1};
    static constexpr int window_bytes = 11;

    Size size() const { return panel_size; }
    template <class Pause>
    void begin(Pause&&)
    {
    }
    void start(Rect area, std::span<const std::byte> pixels)
    {
        REQUIRE(area.x >= 0);
        REQUIRE(area.y >= 0);
        REQUIRE(area.x + area.width <= panel_size.width);
        REQUIRE(area.y + area.height <= panel_size.height);
        const std::size_t bytes = row_bytes(format, area.width);
        REQUIRE(pixels.size() == bytes * static_cast<std::size_t>(area.height));
        for (int y = area.y; y < area.y + area.height; ++y, pixels = pixels.subspan(bytes))
            std::ranges::copy(pixels.first(bytes), memory.begin() + 2 * (y * panel_size.width + area.x));
    }
    bool busy() { return false; }

    Bytes memory = Bytes(row_bytes(format, panel_size.width) * panel_size.height);
};

/// Plays `frames` moments of the scene, each somewhere else.
class LeapingBoard {
public:
    LeapingBoard(Bytes scene, std::size_t block_size)
        : block_{block_size},
          scene_{std::move(scene)},
          reference_{*SceneView::parse(scene_)},
          reference_block_(Player::block_bytes(reference_, panel_size)),
          redrawn_{*Player::create(reference_, panel_size, Fit::contain, reference_block_)}
    {
    }
    LeapingBoard(const LeapingBoard&) = delete;

    QuickPanel& panel() { return panel_; }
    Microseconds now() const { return {}; }
    void sleep_until(Microseconds) {}
    std::span<const std::byte> scene_bytes() const { return scene_; }
    std::span<std::byte> block() { return block_.inside(); }
    std::array<std::span<std::byte>, 2> bands() { return {bands_[0].inside(), bands_[1].inside()}; }
    bool running() const { return shown < frames; }
    void scene_started(const SceneView&) {}
    Playhead playhead(const SceneView& scene)
    {
        Playhead head{scene};
        head.set_speed(16 * Playhead::as_authored - 12'345);
        return head;
    }
    bool wants_redraw() { return random_() % 8 == 0; }
    void frame_shown(FrameReport report)
    {
        ++shown;
        Bytes whole(panel_.memory.size());
        redrawn_.show_moment(report.time);
        redrawn_.draw_rows<QuickPanel::format>(panel_size.height, whole);
        CAPTURE(report.time.ticks);
        REQUIRE(panel_.memory == whole);
    }
    void fault(Error error) { refused = error; }

    bool guards_hold() const
    {
        return block_.guards_hold() && bands_[0].guards_hold() && bands_[1].guards_hold();
    }
    const Guarded& guarded_block() const { return block_; }

    std::size_t frames = 5;
    std::size_t shown = 0;
    std::optional<Error> refused;

private:
    QuickPanel panel_;
    Guarded block_;
    std::array<Guarded, 2> bands_{Guarded{3 * row_bytes(QuickPanel::format, panel_size.width)},
                                  Guarded{3 * row_bytes(QuickPanel::format, panel_size.width)}};
    Bytes scene_;
    SceneView reference_;
    Bytes reference_block_;
    Player redrawn_;
    std::minstd_rand random_{3};
};

std::string begun(const std::string& items)
{
    return "kfast 1\ncanvas 96 64 fps=30 frames=40 background=\"#203040\"\n" + items;
}

/// A coil of 5000 points becomes another, 10,000 in all.
std::string many_points()
{
    std::minstd_rand random{11};
    const auto drawing = [&random] {
        std::string path = "path \"M 0 0 L";
        for (int i = 0; i < 4999; ++i)
            path += ' ' + std::to_string(random() % 96) + ' ' + std::to_string(i * 64 / 4999) + '.' +
                    std::to_string(i * 64 % 4999 * 10 / 4999);
        return path + "\"";
    };
    return begun("object coil fill=\"#f0a0ff80\" {\nkey 0 { " + drawing() + " }\nkey 39 { " + drawing() +
                 " }\n}");
}

std::string many_objects()
{
    std::minstd_rand random{12};
    std::string items;
    for (int i = 0; i < 1000; ++i)
        items += "object o" + std::to_string(i) +
                 " fill=white stroke=red width=1 { key 0 x=0; key 39 x=" + std::to_string(random() % 50) +
                 "; rect " + std::to_string(random() % 90) + ' ' + std::to_string(random() % 60) + " 5 3 }\n";
    return begun(items);
}

/// Curves, joins and caps far larger than the panel, blended several levels deep.
std::string far_beyond_the_edges()
{
    return begun(R"(
group opacity=0.5 {
    group {
        key 0 scale=1 opacity=0.2; key 20 scale=4 opacity=0.9; key 39 scale=0.01
        object blob stroke=yellow width=30 cap=round join=round {
            key 0 rotate=0 law=accelerate { path "M -90 32 C 500 -600 -500 600 190 32 S 10 10 48 32" }
            key 39 rotate=720 { circle 40 30 r=300; circle 0 0 r=1 }
        }
        group opacity=0.4 { object dot fill="#00ff00c0" stroke=black { circle 48 32 r=5 } }
    }
})");
}

Bytes scene_of(const std::string& text) { return compiled(text); }

std::size_t block_for(const Bytes& scene)
{
    return Player::block_bytes(*SceneView::parse(scene), panel_size);
}

}

static_assert(Board<LeapingBoard> && ChoosingBoard<LeapingBoard> && RedrawingBoard<LeapingBoard>);

TEST_CASE("a large scene that has just the memory it asks for writes nowhere else, and shows what it should")
{
    for (const std::string& text : {many_points(), many_objects(), far_beyond_the_edges()}) {
        const Bytes scene = scene_of(text);
        LeapingBoard board{scene, block_for(scene)};
        run(board);
        CHECK_FALSE(board.refused.has_value());
        CHECK(board.shown == board.frames);
        CHECK(board.guards_hold());
    }
}

TEST_CASE("a scene that lacks a byte of memory is refused before a byte is written")
{
    for (const std::string& text : {many_points(), many_objects(), far_beyond_the_edges()}) {
        const Bytes scene = scene_of(text);
        LeapingBoard board{scene, block_for(scene) - 1};
        run(board);
        CHECK(board.refused == Error::block_too_small);
        CHECK(board.shown == 0);
        CHECK(board.guarded_block().is_untouched());
        CHECK(board.guards_hold());
    }
}

}
