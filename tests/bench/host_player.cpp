// Plays a compiled scene as the images of tests/bench/image do, on this computer:
//
//     bench_player frames SCENE     what each frame of the steady loop sends, and how little it could be
//     bench_player speed SCENE      frames in a second of this computer
//     bench_player once SCENE       nothing but the two turns; frame_shown() is called after each of their
//     frames
#include "tests/bench/bench_board.hpp"
#include "tests/bench/steady_pictures.hpp"

#include <array>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

extern "C" void frame_shown();

/// Where callgrind divides its counts (--dump-before).
extern "C" [[gnu::noinline]] void frame_shown() { asm volatile("" ::: "memory"); }

namespace kfast::bench {
namespace {

/// Costs are not told apart.
struct PixelCheck {
    static constexpr bool checks_pixels = true;

    void enter(Phase) {}
    PhaseCosts take() { return {}; }
};

/// The frames are told apart by who watches the program.
struct FrameMark {
    static constexpr bool checks_pixels = false;

    void enter(Phase) {}
    PhaseCosts take()
    {
        frame_shown();
        return {};
    }
};

template <class Meter, class Report>
void play_two_turns(const SceneView& scene, Meter meter, Report report)
{
    std::vector<std::byte> block(Player::block_bytes(scene, scene.canvas()));
    std::array<std::vector<std::byte>, 2> bands;
    bands.fill(std::vector<std::byte>(band_bytes));
    if (!measure(scene, {.block = block, .bands = {bands[0], bands[1]}}, meter, report))
        throw std::runtime_error{"the scene does not fit into the block that it asks for"};
}

void print_frames(const SceneView& scene)
{
    const PlayRange stretch = steady_stretch(scene);
    SteadyPictures pictures{scene, stretch};
    for (std::uint32_t frame = 0; frame < frames_in_turn(stretch); ++frame)
        pictures.advance();
    play_two_turns(scene, PixelCheck{}, [&pictures](const FrameCost& cost) {
        std::printf("frame %u windows %u bytes %u pixels %u changed %u\n", cost.number, cost.traffic.windows,
                    cost.traffic.bytes, cost.traffic.pixels.value(), pictures.changed_bytes());
        pictures.advance();
    });
}

void print_speed(const SceneView& scene)
{
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    std::uint32_t frames = 0;
    std::chrono::duration<double> seconds{};
    do {
        play_two_turns(scene, FrameMark{}, [](const FrameCost&) {});
        frames += 2 * frames_in_turn(steady_stretch(scene));
        seconds = Clock::now() - start;
    } while (seconds.count() < 0.5);
    std::printf("frames_per_second %.0f\n", frames / seconds.count());
}

std::vector<std::byte> read(const char* path)
{
    std::ifstream file{path, std::ios::binary};
    const std::vector<char> chars{std::istreambuf_iterator<char>{file}, {}};
    const auto bytes = std::as_bytes(std::span{chars});
    return {bytes.begin(), bytes.end()};
}

void run(const std::string& wish, const char* path)
{
    const std::vector<std::byte> bytes = read(path);
    const auto parsed = SceneView::parse(bytes);
    if (!parsed)
        throw std::runtime_error{std::string{path} + " is no compiled scene of this version of KFAST"};
    const SceneView& scene = *parsed;
    if (wish == "frames")
        print_frames(scene);
    else if (wish == "speed")
        print_speed(scene);
    else
        play_two_turns(scene, FrameMark{}, [](const FrameCost&) {});
}

}
}

int main(int argc, char** argv)
{
    if (argc != 3) {
        std::cerr << "usage: bench_player frames|speed|once SCENE\n";
        return 2;
    }
    try {
        kfast::bench::run(argv[1], argv[2]);
    } catch (const std::runtime_error& error) {
        std::cerr << "bench_player: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
