// Tells what the core does for each frame of a scene, on a panel of its canvas's size, as the images of
// tests/bench play it: what cost_table.cpp is made from. See scripts/calibrate.
//
//     kfast-work SCENE      a line of names, then for each frame its number, areas, bytes and counts

#include "host/failure.hpp"
#include "host/fit/scene_run.hpp"
#include "host/fit/work_names.hpp"
#include "host/scene_file.hpp"

#include <cstdio>
#include <iostream>

namespace kfast::fit {
namespace {

void print_names()
{
    std::printf("frame areas bytes");
    for (const std::string_view name : work_names)
        std::printf(" %.*s", static_cast<int>(name.size()), name.data());
    std::printf("\n");
}

void print_work(const SceneView& scene)
{
    Target target;
    target.display.size = scene.canvas();
    SceneRun run{scene, target, Fit::contain};
    int number = 0;
    run.visit_first(Time{0}, [](const FrameWork&) {});
    run.visit_turn(Time{0}, [&number](const FrameWork& frame) {
        std::printf("%d %zu %zu", number++, frame.areas, frame.bytes);
        for (const std::uint32_t count : frame.work())
            std::printf(" %u", count);
        std::printf("\n");
    });
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
