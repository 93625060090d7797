#include "host/beam/ilda_reader.hpp"
#include "host/beam/ilda_writer.hpp"
#include "tests/demand.hpp"

#include <cstdint>
#include <stdexcept>
#include <string_view>

using namespace kfast;

namespace {

std::vector<BeamPoints> points_of(const IldaContents& contents)
{
    std::vector<BeamPoints> frames;
    for (const IldaFrame& frame : contents.frames) {
        demand(!frame.points.empty());
        BeamPoints& points = frames.emplace_back();
        for (const IldaPoint& point : frame.points)
            points.push_back(point.point);
    }
    return frames;
}

}

/// Any bytes at all: what is wrong with them is told, or they hold frames, which come back from a file of our
/// own.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
try {
    const IldaContents contents = read_ilda(std::as_bytes(std::span{data, size}));
    demand(ilda_facts(contents).points <= size / 6);
    const auto frames = points_of(contents);
    const IldaContents again = read_ilda(ilda_file("again", IldaFormat::true_colour_3d, frames));
    demand(points_of(again) == frames);
    return 0;
} catch (const std::invalid_argument& reason) {
    demand(std::string_view{reason.what()}.starts_with("at byte "));
    return 0;
}
