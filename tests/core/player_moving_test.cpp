#include "core/player.hpp"

#include "core/bytes/crc32.hpp"
#include "tests/core/moving_scenes.hpp"
#include "tests/core/player_fixture.hpp"
#include "tests/rounds.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <random>
#include <set>
#include <vector>

/// Players of scenes that bones, backbones, paths and turns in space move.
namespace kfast::test {
namespace {

constexpr Size canvas{60, 40};

std::vector<Time> some_times()
{
    std::vector<Time> times;
    for (int ticks = 0; ticks < 30 * 1024; ticks += 1300)
        times.push_back({ticks});
    return times;
}

std::vector<Bytes> pictures_of(const RawScene& scene, const std::vector<Time>& times)
{
    std::vector<Bytes> pictures;
    pictures.reserve(times.size());
    for (const Time time : times)
        pictures.push_back(PlayerFixture{scene.file(), canvas}.picture(time));
    return pictures;
}

}

TEST_CASE("what moves the scenes changes their pictures nearly all the time")
{
    for (const RawScene& scene : moving_scenes()) {
        std::set<std::uint32_t> different;
        for (const Bytes& picture : pictures_of(scene, some_times())) {
            Crc32 crc;
            crc.add(picture);
            different.insert(crc.value());
        }
        CHECK(different.size() + 4 >= some_times().size()); // the last key may come before the end
    }
}

TEST_CASE("a picture is the same whether it is reached forwards, backwards or by a leap")
{
    std::mt19937 random{106};
    const std::vector<Time> times = some_times();
    for (const RawScene& scene : moving_scenes()) {
        const std::vector<Bytes> pictures = pictures_of(scene, times);
        PlayerFixture fixture{scene.file(), canvas};
        for (std::size_t i = 0; i < times.size(); ++i)
            REQUIRE(fixture.picture(times[i]) == pictures[i]);
        for (std::size_t i = times.size(); i-- > 0;)
            REQUIRE(fixture.picture(times[i]) == pictures[i]);
        for (int round = 0; round < 60; ++round) {
            const std::size_t i = random() % times.size();
            if (round % 3 == 0) { // rows that are left undrawn do not matter either
                fixture.player.show({static_cast<std::int32_t>(random())});
                Bytes few_rows(60 * 2 * 7);
                fixture.player.draw_rows<PixelFormat::rgb565>(7, few_rows);
            }
            REQUIRE(fixture.picture(times[i]) == pictures[i]);
        }
    }
}

TEST_CASE("the picture of what moves in space or is carried does not depend on the height of the bands")
{
    for (const RawScene& scene : moving_scenes()) {
        PlayerFixture fixture{scene.file(), {61, 33}};
        for (const int frame : {0, 7, 13, 22, 27}) {
            const Bytes whole = fixture.picture<PixelFormat::grey4>(Time::frame(frame));
            for (const int band_rows : {1, 3, 8, 32})
                CHECK(fixture.picture<PixelFormat::grey4>(Time::frame(frame), band_rows) == whole);
        }
    }
}

TEST_CASE("no moment of what is carried or turned needs more steps than can be told beforehand")
{
    std::mt19937 random{107};
    for (const RawScene& scene : moving_scenes())
        for (const Size panel : {canvas, Size{7, 5}, Size{480, 320}}) {
            PlayerFixture fixture{scene.file(), panel};
            for (int round = 0; round < rounds(1000); ++round) {
                fixture.player.show({static_cast<std::int32_t>(random())});
                CHECK(fixture.player.picture().step_count <= fixture.scene.paint_steps());
            }
        }
}

TEST_CASE("a player of what is carried or turned writes to its block alone")
{
    constexpr std::size_t guard = 64;
    constexpr std::byte mark{0xA5};
    for (const RawScene& raw : moving_scenes()) {
        const Bytes file = raw.file();
        const SceneView scene = *SceneView::parse(file);
        const std::size_t size = Player::block_bytes(scene, canvas);
        Bytes memory(size + 2 * guard, mark);
        auto player = Player::create(scene, canvas, Fit::cover, std::span{memory}.subspan(guard, size));
        REQUIRE(player);
        Bytes pixels(row_bytes(PixelFormat::rgb565, canvas.width) * static_cast<std::size_t>(canvas.height));
        for (int frame = 0; frame < 30; ++frame) {
            player->show(Time::frame(frame));
            player->draw_rows<PixelFormat::rgb565>(canvas.height, pixels);
        }
        const auto is_untouched = [](std::span<const std::byte> part) {
            return std::ranges::all_of(part, [](std::byte byte) { return byte == mark; });
        };
        CHECK(is_untouched(std::span{memory}.first(guard)));
        CHECK(is_untouched(std::span{memory}.last(guard)));
    }
}

TEST_CASE("a block has room for placed items in each other, all bones, and one object's backbones")
{
    const auto extra_bytes = [](const RawScene& raw) {
        const Bytes file = raw.file();
        const SceneView scene = *SceneView::parse(file);
        const std::size_t outline_bytes = scene.outline_bytes() + 4; // of a panel as large as the canvas
        const raster::RendererNeeds needs{
            .outline_bytes = outline_bytes,
            .record_bytes = std::min(scene.borders() * std::size_t{6} + 4, std::size_t{36} * canvas.height),
            .cache_bytes = scene.cache_bytes() + 4,
            .steps = scene.paint_steps(),
            .group_depth = scene.blended_depth()};
        return Player::block_bytes(scene, scene.canvas()) -
               raster::Renderer::block_bytes(needs, scene.canvas()) - PreparedScene::bytes_for(scene);
    };
    CHECK(extra_bytes(space_scene()) == 3 * sizeof(Space) + 4); // three lie in each other, and all are turned
    CHECK(extra_bytes(bones_scene()) == 5 * sizeof(PosedBone));
    CHECK(extra_bytes(backbones_scene()) == 7 * sizeof(BackboneNode));
}

}
