#include "core/scene/scene_view.hpp"
#include "firmware/run/dac_point.hpp"
#include "firmware/settings/board_record.hpp"
#include "host/beam/beam_source.hpp"

#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

/// What a beam is to be told: beam-words RECORD SCENE.kfb POINTS writes a line for every frame of
/// the scene, the last moment included: its points in hexadecimal, as dac_point() makes them. A picture has
/// no more than POINTS.
namespace {

using namespace kfast;

std::vector<std::byte> bytes_of(const char* file)
{
    std::ifstream stream{file, std::ios::binary};
    const std::string text{std::istreambuf_iterator<char>{stream}, {}};
    const auto bytes = std::as_bytes(std::span{text});
    return {bytes.begin(), bytes.end()};
}

void write_words(const char* record, const char* file, std::uint32_t budget)
{
    const auto settings = read_board_record(bytes_of(record));
    const auto bytes = bytes_of(file);
    const auto scene = SceneView::parse(bytes);
    if (!settings || !scene)
        throw std::runtime_error{"no board record, or no scene"};
    BeamSource source{*scene, settings->beam, budget};
    std::cout << std::hex;
    for (Time time{}; time <= scene->length(); time = time + Time::frame(1)) {
        for (const BeamPoint& point : source.show(time))
            std::cout << dac_point(point, settings->beam.brightness) << ' ';
        std::cout << '\n';
    }
}

}

int main(int argc, char** argv)
{
    try {
        if (argc != 4)
            throw std::runtime_error{"usage: beam-words RECORD SCENE.kfb POINTS"};
        write_words(argv[1], argv[2], static_cast<std::uint32_t>(std::atoi(argv[3])));
    } catch (const std::exception& problem) {
        std::cerr << "beam-words: " << problem.what() << '\n';
        return EXIT_FAILURE;
    }
}
