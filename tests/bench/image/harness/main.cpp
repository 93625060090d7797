#include "tests/bench/image/harness/instruction_meter.hpp"
#include "tests/bench/image/harness/painted_stack.hpp"
#include "tests/bench/image/harness/semihosting.hpp"
#include "tests/bench/image/measured_scene.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

extern "C" {
// From the linker script.
extern const std::byte scene_region_begin[];
extern const std::byte scene_region_end[];
extern const volatile std::uint32_t profile_wanted;
extern std::byte block_begin[];
extern std::byte block_end[];
}

namespace kfast::bench {
namespace {

alignas(4) std::array<std::array<std::byte, band_bytes>, 2> band_buffers;

Workspace workspace()
{
    return {.block = {block_begin, block_end}, .bands = {band_buffers[0], band_buffers[1]}};
}

void write_field(const char* name, std::uint32_t value)
{
    semihosting::write(name);
    semihosting::write(value);
}

int refuse(Error error)
{
    write_field("error ", static_cast<std::uint32_t>(error));
    semihosting::write("\n");
    return 1;
}

std::uint32_t cost(const FrameCost& frame, Phase phase)
{
    return frame.phases[static_cast<std::size_t>(phase)];
}

}

void report_frame(const FrameCost& frame)
{
    write_field("frame ", frame.number);
    write_field(" update ", cost(frame, Phase::update));
    write_field(" draw ", cost(frame, Phase::draw));
    write_field(" send ", cost(frame, Phase::send));
    write_field(" windows ", frame.traffic.windows);
    write_field(" bytes ", frame.traffic.bytes);
    write_field(" pixels ", frame.traffic.pixels.value());
    semihosting::write("\n");
}

int run()
{
    InstructionMeter meter;
    meter.begin();
    meter.enter(Phase::load);
    const auto scene = SceneView::parse({scene_region_begin, scene_region_end}, linked_features);
    meter.enter(Phase::elsewhere);
    const std::uint32_t check = meter.take()[static_cast<std::size_t>(Phase::load)];
    if (!scene)
        return refuse(scene.error());
    write_field("lent ", static_cast<std::uint32_t>(block_end - block_begin));
    write_field(" needed ", static_cast<std::uint32_t>(Player::block_bytes(*scene, scene->canvas())));
    semihosting::write("\n");
    const auto played =
        profile_wanted != 0 ? profile_scene(*scene, workspace()) : measure_scene(*scene, workspace());
    if (!played)
        return refuse(played.error());
    write_field("check ", check);
    write_field(" load ", check + *played);
    write_field(" stack ", used_stack());
    semihosting::write("\nend\n");
    return 0;
}

}

int main() { return kfast::bench::run(); }
