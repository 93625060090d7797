#include "core/beam/beam_player.hpp"
#include "core/bytes/crc32.hpp"
#include "tests/bench/image/harness/instruction_meter.hpp"
#include "tests/bench/image/harness/painted_stack.hpp"
#include "tests/bench/image/harness/sampler.hpp"
#include "tests/bench/image/harness/semihosting.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

extern "C" {
// From the linker script.
extern const std::byte scene_region_begin[];
extern const std::byte scene_region_end[];
extern const volatile std::uint32_t profile_wanted;
extern std::byte block_begin[];
extern std::byte block_end[];
}

/// Counts what it takes to compute and to plot every picture of a scene for the beam of an oscilloscope.
namespace kfast::bench {
namespace {

void write_field(const char* name, std::uint32_t value)
{
    semihosting::write(name);
    semihosting::write(value);
}

template <class Meter>
void play(BeamPlayer& player, Meter& meter)
{
    std::array<BeamPoint, 64> points;
    const std::int32_t frames = player.scene().length().ticks / Time::ticks_per_frame;
    for (std::int32_t shown = 0; shown < 2 * frames; ++shown) { // the second turn counts
        const std::int32_t frame = shown % frames;
        meter.enter(Phase::update);
        player.show(Time::frame(frame));
        meter.enter(Phase::draw);
        PointStream plot = player.plot();
        meter.enter(Phase::elsewhere);
        Crc32 crc;
        std::size_t count = 0;
        do {
            meter.enter(Phase::draw);
            count = plot.next(points);
            meter.enter(Phase::elsewhere);
            crc.add(std::as_bytes(std::span{points}.first(count)));
        } while (count != 0);
        const auto costs = meter.take();
        if (shown < frames)
            continue;
        write_field("frame ", static_cast<std::uint32_t>(frame));
        write_field(" update ", costs[static_cast<std::size_t>(Phase::update)]);
        write_field(" draw ", costs[static_cast<std::size_t>(Phase::draw)]);
        write_field(" points ", player.report().points);
        write_field(" lines ", player.report().lines);
        write_field(" corners ", player.report().corners);
        write_field(" compared ", player.report().compared);
        write_field(" haste ", static_cast<std::uint32_t>(player.report().speed_level));
        write_field(" crc ", crc.value());
        semihosting::write("\n");
    }
}

int run()
{
    const auto scene = SceneView::parse({scene_region_begin, scene_region_end}, every_feature_but_outlines);
    if (!scene)
        return 1;
    const BeamProfile& profile = scope_profile;
    write_field("lent ", static_cast<std::uint32_t>(block_end - block_begin));
    write_field(" needed ", static_cast<std::uint32_t>(BeamPlayer::block_bytes(*scene, profile)));
    semihosting::write("\n");
    auto player = BeamPlayer::create(*scene, profile, profile.rate, {block_begin, block_end});
    if (!player)
        return 1;
    if (profile_wanted != 0) {
        Sampler sampler;
        play(*player, sampler);
    } else {
        InstructionMeter meter;
        meter.begin();
        play(*player, meter);
    }
    write_field("stack ", used_stack());
    semihosting::write("\nend\n");
    return 0;
}

}
}

int main() { return kfast::bench::run(); }
