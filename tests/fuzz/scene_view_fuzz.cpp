#include "core/crc32.hpp"
#include "core/player.hpp"

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace kfast {
namespace {

using Bytes = std::vector<std::byte>;

constexpr Size panel{24, 17};

/// Any scene that is not refused can be shown at every frame and between them, within the memory it asks for.
void play(std::span<const std::byte> bytes)
{
    const auto scene = SceneView::parse(bytes);
    if (!scene)
        return;
    Bytes block(Player::block_bytes(*scene, panel));
    auto player = Player::create(*scene, panel, Fit::contain, block);
    if (!player)
        std::abort();
    Bytes pixels(row_bytes(PixelFormat::rgb565, panel.width) * panel.height);
    const std::int32_t step = std::max(Time::ticks_per_frame / 2, scene->length().ticks / 50);
    for (Time time; time <= scene->length(); time.ticks += step) {
        player->show(time);
        if (player->edge_count() > scene->max_edges())
            std::abort();
        player->draw_rows<PixelFormat::rgb565>(panel.height, pixels);
    }
}

void put(Bytes& bytes, std::size_t offset, std::uint32_t value)
{
    for (int shift = 0; shift < 32; shift += 8)
        bytes[offset++] = static_cast<std::byte>(value >> shift & 255);
}

/// The same bytes with a size and a checksum that fit, so that the fuzzer gets past them.
Bytes sealed(std::span<const std::byte> bytes)
{
    Bytes copy(bytes.begin(), bytes.end());
    put(copy, 8, static_cast<std::uint32_t>(copy.size()));
    Crc32 crc;
    crc.add(std::span{copy}.subspan(8));
    put(copy, 4, crc.value());
    return copy;
}

}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto bytes = std::as_bytes(std::span{data, size});
    kfast::play(bytes);
    if (size >= 12)
        kfast::play(kfast::sealed(bytes));
    return 0;
}
