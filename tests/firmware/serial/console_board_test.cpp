#include "firmware/serial/console_board.hpp"

#include "firmware/run/run.hpp"
#include "tests/bytes.hpp"
#include "tests/compiled.hpp"
#include "tests/firmware/serial/recorded_console.hpp"

#include <array>
#include <sstream>
#include <string>
#include <vector>

namespace kfast::test {
namespace {

constexpr Size glass{.width = 8, .height = 4};
constexpr int whole_picture = 8 * 4 * 2 + 5;

/// Passes a microsecond with every look at it.
class TickingClock {
public:
    void begin() { is_begun_ = true; }
    Microseconds now() const
    {
        REQUIRE(is_begun_);
        return {++microseconds_};
    }
    void sleep_until(Microseconds moment) const { microseconds_ = moment.count; }

private:
    bool is_begun_ = false;
    mutable std::uint32_t microseconds_ = 0;
};

class Glass {
public:
    static constexpr PixelFormat format = PixelFormat::rgb565;
    static constexpr Size granularity{.width = 1, .height = 1};
    static constexpr int window_bytes = 5;

    Size size() const { return glass; }
    template <class Pause>
    void begin(Pause&&)
    {
    }
    void start(Rect, std::span<const std::byte>) {}
    bool busy() const { return false; }
};

class TestBoard : public ConsoleBoard<RecordedConsole, TickingClock, Glass, glass> {
public:
    TestBoard(RecordedConsole& console, std::vector<std::byte> scene)
        : ConsoleBoard{console}, scene_{std::move(scene)}
    {
        begin("test glass 8x4 rgb565");
    }

    Glass& panel() { return panel_; }
    std::span<const std::byte> scene_bytes() const { return scene_; }
    std::span<std::byte> block() { return block_; }
    std::array<std::span<std::byte>, 2> bands() { return {bands_[0], bands_[1]}; }
    void scene_started(const SceneView& scene) { report_scene(scene_bytes().first(scene.size())); }

private:
    std::vector<std::byte> scene_;
    alignas(4) std::array<std::byte, 16 * 1024> block_;
    alignas(4) std::array<std::array<std::byte, whole_picture>, 2> bands_;
    Glass panel_;
};

static_assert(RedrawingBoard<TestBoard> && WatchingBoard<TestBoard> && EventBoard<TestBoard>);

/// Three frames, of which the last shows what the second does.
std::vector<std::byte> scene()
{
    return compiled("kfast 1\n"
                    "canvas 8 4 fps=25 frames=3 loop=once\n"
                    "object o fill=white { key 0 law=hold { rect 0 0 2 4 }; key 1 { rect 4 0 2 4 } }\n"
                    "event 0 begin\nevent 0.5 soon\nevent 1 one");
}

/// Runs the board for as long as it wants to, and returns the lines that it has told.
std::vector<std::string> lines_by(TestBoard& board, RecordedConsole& console)
{
    while (board.wants_to_run())
        run(board);
    std::istringstream text{console.written};
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);)
        lines.push_back(line);
    return lines;
}

std::vector<std::string> lines_of(std::vector<std::byte> bytes, std::string typed)
{
    RecordedConsole console;
    console.typed = std::move(typed);
    TestBoard board{console, std::move(bytes)};
    return lines_by(board, console);
}

std::string hex(std::uint32_t number)
{
    RecordedConsole console;
    write_hex(console, number);
    return console.written;
}

std::string checksum(std::span<const std::byte> bytes)
{
    Crc32 crc;
    crc.add(bytes);
    return hex(crc.value());
}

/// The hash of a black picture with two white columns, `left` the first of them.
std::string hash_with_columns(int left)
{
    std::vector<std::byte> picture;
    for (int pixel = 0; pixel < glass.width * glass.height; ++pixel) {
        const bool is_white = pixel % glass.width / 2 * 2 == left;
        picture.insert(picture.end(), 2, is_white ? std::byte{0xFF} : std::byte{0});
    }
    return checksum(picture);
}

std::string frame(int index, int left, int bytes)
{
    return "F " + std::to_string(index * 1024) + " " + hash_with_columns(left) + " " + std::to_string(bytes);
}

}

TEST_CASE("stepped, each frame stands until it is answered")
{
    const auto bytes = scene();
    const auto lines = lines_of(bytes, "snnq");
    REQUIRE(lines.size() == 11);
    CHECK(lines[0].starts_with("KFAST "));
    CHECK(lines[0].ends_with(" test glass 8x4 rgb565"));
    CHECK(lines[1] == "SCENE " + std::to_string(bytes.size()) + " " + checksum(bytes));
    CHECK(lines[2] == "STEP");
    CHECK(lines[3] == lines[1]);
    CHECK(lines[4] == "EVENT begin");
    CHECK(lines[5] == frame(0, 0, whole_picture));
    CHECK(lines[6] == "EVENT soon");
    CHECK(lines[7] == "EVENT one");
    CHECK(lines[8].starts_with("F 1024 " + hash_with_columns(4) + " "));
    CHECK(lines[9] == frame(2, 4, 0));
    CHECK(lines[10] == "END");
}

TEST_CASE("more bytes after the scene are not told of")
{
    auto bytes = scene();
    const auto lines = lines_of(bytes, "sq");
    bytes.resize(bytes.size() + 3);
    CHECK(lines_of(bytes, "sq") == lines);
}

TEST_CASE("what is sent counts with its windows, for one frame")
{
    RecordedConsole console;
    TestBoard board{console, {}};
    board.watch({0, 0, 8, 4}, std::vector<std::byte>(64));
    board.watch({0, 0, 2, 4}, std::vector<std::byte>(16, std::byte{0xFF}));
    console.written.clear();
    board.frame_shown({});
    board.frame_shown({.time = {1024}});
    CHECK(console.written == frame(0, 0, 64 + 16 + 2 * 5) + "\n" + frame(1, 0, 0) + "\n");
}

TEST_CASE("a frame is sent whole on demand")
{
    const auto lines = lines_of(scene(), "snrq");
    REQUIRE(lines.size() == 11);
    CHECK(lines[9] == frame(2, 4, whole_picture));
}

TEST_CASE("running freely, it ends on demand, and other letters do not matter")
{
    CHECK(lines_of(scene(), "q").back() == "END");
    const auto lines = lines_of(scene(), "xq");
    REQUIRE(lines.size() == 5);
    CHECK(lines[3] == frame(0, 0, whole_picture));
    CHECK(lines[4] == "END");
}

TEST_CASE("running freely, frames come by the clock and a whole one on demand")
{
    const auto lines = lines_of(scene(), "xxrq");
    REQUIRE(lines.size() == 9);
    CHECK(lines[7] == frame(2, 4, whole_picture));
}

TEST_CASE("the clock stands while a frame does")
{
    RecordedConsole console;
    console.typed = "sx";
    TestBoard board{console, scene()};
    const Microseconds before = board.now();
    CHECK(board.now() != before);
    board.frame_shown({});
    CHECK(!board.running());
    const Microseconds stepped = board.now();
    CHECK(board.now() == stepped);

    board.sleep_until({7});
    CHECK(console.typed == "x"); // no frame stands yet: the panel is begun again
    board.frame_shown({});
    board.sleep_until({9});
    CHECK(console.typed.empty());
    board.sleep_until({11});
    CHECK(board.now() == Microseconds{11});
}

TEST_CASE("what cannot be played is told, and ends it")
{
    const auto lines = lines_of(bytes({1, 2, 3, 4}), "");
    REQUIRE(lines.size() == 2);
    CHECK(lines[1] == "ERROR bad_magic: not a compiled scene");
}

}
