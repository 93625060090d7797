#include "host/picture/board_source.hpp"

#include "firmware/run.hpp"
#include "host/failure.hpp"

namespace kfast {
namespace {

std::vector<std::byte> packed(const std::vector<std::uint8_t>& levels)
{
    std::vector<std::byte> bytes(levels.size() / 2);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<std::byte>(levels[2 * i] << 4 | levels[2 * i + 1]);
    return bytes;
}

}

BoardSource::BoardSource(std::span<const std::byte> scene)
    : board_{scene, 1}, frame_{PixelFormat::grey4, {Ssd0323Model::width, Ssd0323Model::height}, {}}
{
}

const Frame& BoardSource::show(Time moment)
{
    board_.start_at(moment);
    run(board_);
    if (board_.error())
        throw Failure("the simulated board cannot play this scene");
    if (const auto mistake = board_.bus_error())
        throw Failure("the simulated panel was driven wrongly: " + *mistake);
    frame_.pixels = packed(board_.frames().front().picture);
    return frame_;
}

}
