// Prints what the core does for each frame of a scene, on a panel of its canvas's size, as the images of
// tests/bench play it: what cost_table.cpp is made from (scripts/calibrate), and what it makes of that.
//
//     kfast-work SCENE      a line of names; then for each frame its areas, bytes, the instructions that the
//                           table predicts for each processor, and the counts

#include "host/compile/scene_file.hpp"
#include "host/fit/cost_table.hpp"
#include "host/fit/op_counts.hpp"
#include "host/fit/scene_run.hpp"
#include "host/program/failure.hpp"

#include <cstdio>
#include <iostream>

namespace kfast::fit {
namespace {

void print_names()
{
    std::printf("areas bytes cortex-m0 cortex-m3 cortex-m4 cortex-m7 cortex-m33");
    for (const std::string_view name : op_names)
        std::printf(" %.*s", static_cast<int>(name.size()), name.data());
    std::printf("\n");
}

void print(const FrameOps& frame)
{
    const OpCounts work = frame.work();
    std::printf("%zu %zu", frame.areas, frame.bytes);
    for (std::size_t i = 0; i < processor_count; ++i)
        std::printf(" %.0f", instructions(work, frame.areas, costs_of(static_cast<Processor>(i))));
    for (const std::uint32_t count : work)
        std::printf(" %u", count);
    std::printf("\n");
}

void print_work(const SceneView& scene)
{
    Target target;
    target.display.size = scene.canvas();
    SceneRun run{scene, target, Fit::contain};
    run.visit_first(Time{0}, [](const FrameOps&) {});
    run.visit_turn(Time{0}, print);
}

}
}

int main(int count, char** arguments)
{
    if (count != 2) {
        std::cerr << "usage: kfast-work SCENE\n";
        return 2;
    }
    try {
        kfast::fit::print_names();
        kfast::fit::print_work(kfast::load_scene(arguments[1]).view);
    } catch (const kfast::Failure& failure) {
        std::cerr << failure.what() << '\n';
        return 1;
    }
    return 0;
}
