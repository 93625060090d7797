#include "core/scene_view.hpp"

#include "core/crc32.hpp"
#include "core/kfb_limits.hpp"
#include "core/player.hpp"
#include "tests/compiled.hpp"

#include <doctest/doctest.h>
#include <functional>
#include <random>

namespace kfast::test {
namespace {

using Bytes = std::vector<std::byte>;

constexpr std::string_view two_objects = R"(
kfast 1
canvas 64 48 fps=25 background="#102030" loop=ping-pong frames=40
palette { ink "#ffffff"; glow "#4cc9f0" }
object ball fill=glow {
    key 0 law=accelerate { circle 16 16 r=6 }
    key 20.5 law-x=constant law-y=decelerate { rect 30 10 20 20 corner=4; circle 10 40 r=2 }
    key 40
}
object wire stroke=ink width=2.5 cap=round join=bevel {
    path "M 4 4 L 60 4 C 60 20 40 30 60 44"
}
)";

void put(Bytes& bytes, std::size_t offset, std::uint32_t value, int count)
{
    for (int i = 0; i < count; ++i)
        bytes.at(offset + static_cast<std::size_t>(i)) = static_cast<std::byte>(value >> 8 * i);
}

/// As a writer who makes a mistake would leave the scene: size and checksum fit, the rest does not.
Bytes sealed(Bytes bytes)
{
    put(bytes, 8, static_cast<std::uint32_t>(bytes.size()), 4);
    Crc32 crc;
    crc.add(std::span{bytes}.subspan(8));
    put(bytes, 4, crc.value(), 4);
    return bytes;
}

Error error_after(const std::function<void(Bytes&)>& damage)
{
    Bytes bytes = compiled(two_objects);
    damage(bytes);
    const auto scene = SceneView::parse(sealed(bytes));
    REQUIRE(!scene);
    return scene.error();
}

Error error_of(std::span<const std::byte> bytes)
{
    const auto scene = SceneView::parse(bytes);
    REQUIRE(!scene);
    return scene.error();
}

constexpr std::size_t first_object = 32 + 3 * 3 + 1; ///< behind header, palette and the length of the objects

}

TEST_CASE("a scene says what was compiled into it")
{
    const Bytes bytes = compiled(two_objects);
    const auto scene = SceneView::parse(bytes);
    REQUIRE(scene);
    CHECK(scene->size() == bytes.size());
    CHECK(scene->canvas() == Size{64, 48});
    CHECK(scene->frame_rate() == 25'000);
    CHECK(scene->length() == Time::frame(40));
    CHECK(scene->loop() == Loop::ping_pong);
    CHECK(scene->object_count() == 2);
    CHECK(scene->layers() == 2);
    CHECK(scene->colour(0) == Colour{0x10, 0x20, 0x30});
    ObjectCursor objects = scene->objects();
    const ObjectView ball = objects.next();
    CHECK(ball.style.is_filled);
    CHECK(!ball.style.is_stroked);
    CHECK(scene->colour(ball.style.fill) == Colour{0x4c, 0xc9, 0xf0});
    const ObjectView wire = objects.next();
    CHECK(objects.at_end());
    CHECK(wire.style.width == 40);
    CHECK(wire.style.cap == Cap::round);
    CHECK(wire.style.join == Join::bevel);
}

TEST_CASE("an object knows the keys around a moment")
{
    const Bytes bytes = compiled(two_objects);
    const auto scene = SceneView::parse(bytes);
    REQUIRE(scene);
    const ObjectView ball = scene->objects().next();
    const auto around = [&ball](double frame) {
        const KeyInterval interval = ball.interval_at({static_cast<std::int32_t>(frame * 1024)});
        return std::pair{interval.from.time.ticks / 1024.0, interval.to.time.ticks / 1024.0};
    };
    CHECK(around(0) == std::pair{0.0, 20.5});
    CHECK(around(20.499) == std::pair{0.0, 20.5});
    CHECK(around(20.5) == std::pair{20.5, 40.0});
    CHECK(around(40) == std::pair{40.0, 40.0});
    CHECK(around(1000) == std::pair{40.0, 40.0});
    CHECK(around(-5) == std::pair{0.0, 0.0});
    const KeyInterval second = ball.interval_at(Time::frame(30));
    CHECK(second.from.law_x == VelocityLaw::constant);
    CHECK(second.from.law_y == VelocityLaw::decelerate);
    CHECK(scene->drawing(second.from).strokes() == 2);
    CHECK(scene->drawing(second.to).strokes() == 0);
}

TEST_CASE("bytes behind the scene are ignored")
{
    Bytes bytes = compiled(two_objects);
    bytes.resize(bytes.size() + 100, std::byte{0xFF});
    CHECK(SceneView::parse(bytes));
}

TEST_CASE("a scene that is cut anywhere is refused as truncated")
{
    const Bytes bytes = compiled(two_objects);
    for (std::size_t size = 0; size < bytes.size(); ++size)
        CHECK(error_of(std::span{bytes}.first(size)) == Error::truncated);
}

TEST_CASE("a flipped bit anywhere is noticed")
{
    const Bytes bytes = compiled(two_objects);
    for (std::size_t bit = 0; bit < bytes.size() * 8; ++bit) {
        Bytes damaged = bytes;
        damaged[bit / 8] ^= static_cast<std::byte>(1 << bit % 8);
        CHECK(!SceneView::parse(damaged));
    }
}

TEST_CASE("other files and other versions are named as such")
{
    Bytes bytes = compiled(two_objects);
    bytes[3] = std::byte{kfb::version + 1};
    CHECK(error_of(bytes) == Error::unsupported_version);
    bytes[0] = std::byte{'G'};
    CHECK(error_of(bytes) == Error::bad_magic);
    CHECK(error_of(Bytes(200)) == Error::bad_magic);
}

TEST_CASE("every value out of its range is refused, checksum or not")
{
    SUBCASE("canvas")
    {
        CHECK(error_after([](Bytes& bytes) { put(bytes, 24, 0, 2); }) == Error::bad_scene);
        CHECK(error_after([](Bytes& bytes) { put(bytes, 26, 2048, 2); }) == Error::bad_scene);
    }
    SUBCASE("length")
    {
        CHECK(error_after([](Bytes& bytes) { put(bytes, 16, 1023, 4); }) == Error::bad_scene);
        CHECK(error_after([](Bytes& bytes) { put(bytes, 16, 0xFFFFFFFF, 4); }) == Error::bad_scene);
    }
    SUBCASE("frame rate")
    {
        CHECK(error_after([](Bytes& bytes) { put(bytes, 20, 0, 4); }) == Error::bad_scene);
        CHECK(error_after([](Bytes& bytes) { put(bytes, 20, 1'000'001, 4); }) == Error::bad_scene);
    }
    SUBCASE("objects")
    {
        CHECK(error_after([](Bytes& bytes) { put(bytes, 28, 3, 2); }) == Error::bad_scene);
    }
    SUBCASE("bytes behind the last object")
    {
        CHECK(error_after([](Bytes& bytes) {
                  const auto object_bytes = std::to_integer<std::uint32_t>(bytes[first_object - 1]);
                  put(bytes, first_object - 1, object_bytes + 1, 1);
                  bytes.insert(bytes.begin() + first_object + object_bytes, std::byte{0});
              }) == Error::bad_scene);
    }
    SUBCASE("palette")
    {
        CHECK(error_after([](Bytes& bytes) { put(bytes, 30, 0, 1); }) == Error::bad_scene);
        CHECK(error_after([](Bytes& bytes) { put(bytes, 30, 255, 1); }) == Error::bad_scene);
    }
    SUBCASE("loop mode")
    {
        CHECK(error_after([](Bytes& bytes) { put(bytes, 31, 3, 1); }) == Error::bad_scene);
    }
    SUBCASE("colour index")
    {
        CHECK(error_after([](Bytes& bytes) { put(bytes, first_object + 1, 3, 1); }) == Error::bad_scene);
    }
    SUBCASE("an object that is neither filled nor stroked")
    {
        CHECK(error_after([](Bytes& bytes) { put(bytes, first_object, 0, 1); }) == Error::bad_scene);
    }
    SUBCASE("reserved bits of a style")
    {
        CHECK(error_after([](Bytes& bytes) { put(bytes, first_object, 0x41, 1); }) == Error::bad_scene);
        CHECK(error_after([](Bytes& bytes) { put(bytes, first_object, 0x05, 1); }) == Error::bad_scene);
    }
    SUBCASE("velocity law")
    {
        CHECK(error_after([](Bytes& bytes) { put(bytes, first_object + 4, 0x04, 1); }) == Error::bad_scene);
        CHECK(error_after([](Bytes& bytes) { put(bytes, first_object + 4, 0x40, 1); }) == Error::bad_scene);
    }
    SUBCASE("pieces of a curve")
    {
        CHECK(error_after([](Bytes& bytes) { put(bytes, first_object + 5, 0, 1); }) == Error::bad_scene);
    }
    SUBCASE("a key at the time of the one before")
    {
        CHECK(error_after([](Bytes& bytes) { put(bytes, first_object + 7, 0, 1); }) == Error::bad_scene);
    }
    SUBCASE("a drawing outside the file")
    {
        CHECK(error_after([](Bytes& bytes) { put(bytes, first_object + 6, 0x7F, 1); }) == Error::bad_scene);
    }
}

TEST_CASE("a bound on memory that is too low is refused, a higher one is kept")
{
    const Bytes bytes = compiled(two_objects);
    const std::uint32_t edges = SceneView::parse(bytes)->max_edges();
    CHECK(error_after([edges](Bytes& damaged) { put(damaged, 12, edges - 1, 4); }) == Error::bad_scene);
    CHECK(error_after([](Bytes& damaged) { put(damaged, 12, 65535, 4); }) == Error::bad_scene);
    Bytes generous = bytes;
    put(generous, 12, edges + 7, 4);
    generous = sealed(generous);
    CHECK(SceneView::parse(generous)->max_edges() == edges + 7);
}

TEST_CASE("whatever a wrong writer seals is refused or can be played")
{
    std::mt19937 random{21};
    const Bytes bytes = compiled(two_objects);
    int played = 0;
    for (int round = 0; round < 3000; ++round) {
        Bytes damaged = bytes;
        for (auto changes = 1 + random() % 3; changes > 0; --changes)
            damaged[12 + random() % (bytes.size() - 12)] = static_cast<std::byte>(random());
        damaged = sealed(damaged);
        const auto scene = SceneView::parse(damaged);
        if (!scene)
            continue;
        constexpr Size panel{16, 16};
        Bytes block(Player::block_bytes(*scene, panel));
        auto player = Player::create(*scene, panel, Fit::contain, block);
        REQUIRE(player);
        player->show({static_cast<std::int32_t>(random())});
        REQUIRE(player->edge_count() <= scene->max_edges());
        Bytes pixels(16 * 16 * 2);
        player->draw_rows<PixelFormat::rgb565>(16, pixels);
        ++played;
    }
    CHECK(played > 100);
}

}
