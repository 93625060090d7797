#include "core/scene/scene_view.hpp"

#include "core/player.hpp"
#include "core/scene/kfb_limits.hpp"
#include "host/compiler/write/header.hpp"
#include "tests/compiled.hpp"
#include "tests/core/everything.hpp"

#include <doctest/doctest.h>
#include <random>

namespace kfast::test {
namespace {

using Bytes = std::vector<std::byte>;

constexpr std::string_view two_objects = R"(
kfast 1
canvas 64 48 fps=25 background="#102030" loop=ping-pong frames=40
palette { ink "#ffffff"; glow "#4cc9f080" }
object ball fill=glow {
    key 0 law=accelerate { circle 16 16 r=6 }
    key 20.5 law-x=constant law-y=decelerate { rect 30 10 20 20 corner=4; circle 10 40 r=2 }
    key 40 { empty }
}
object wire stroke=ink width=2.5 cap=round join=bevel {
    path "M 4 4 L 60 4 C 60 20 40 30 60 44"
}
)";

/// What the size counts.
Bytes body_of(const Bytes& bytes)
{
    ByteReader reader{std::span{bytes}.subspan(8)};
    reader.varint();
    return {reader.rest().begin(), reader.rest().end()};
}

/// As a writer who makes a mistake would leave the scene: size and checksum fit, the rest does not.
Bytes with_body(const Bytes& bytes)
{
    ByteWriter body;
    body.append(bytes);
    return sealed(body);
}

Error error_of(std::span<const std::byte> bytes)
{
    const auto scene = SceneView::parse(bytes);
    REQUIRE(!scene);
    return scene.error();
}

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
    CHECK(scene->palette_size() == 3);
    CHECK(scene->symbol_count() == 0);
    CHECK(scene->paint_steps() == 2);
    CHECK(scene->blended_depth() == 0);
    CHECK(scene->colour(0) == Colour{0x10, 0x20, 0x30});
    ItemCursor items = scene->items();
    const ObjectView ball = items.next().object;
    CHECK(ball.style.is_filled);
    CHECK(!ball.style.is_stroked);
    CHECK(scene->colour(ball.style.fill) == Colour{0x4c, 0xc9, 0xf0, 0x80});
    const ObjectView wire = items.next().object;
    CHECK(items.at_end());
    CHECK(wire.style.width == 40);
    CHECK(wire.style.cap == Cap::round);
    CHECK(wire.style.join == Join::bevel);
}

TEST_CASE("keys have the laws and the drawings that they were given")
{
    const Bytes bytes = compiled(two_objects);
    const SceneView scene = *SceneView::parse(bytes);
    KeyCursor keys = scene.items().next().object.keys();
    const Key first = keys.next();
    CHECK(first.time == Time{});
    CHECK(scene.laws(first.laws) == LawPair{VelocityLaw::accelerate, VelocityLaw::accelerate});
    CHECK(scene.drawing(first.drawing).strokes() == 1);
    const Key second = keys.next();
    CHECK(second.time == Time{20 * 1024 + 512});
    CHECK(scene.laws(second.laws) == LawPair{VelocityLaw::constant, VelocityLaw::decelerate});
    CHECK(scene.drawing(second.drawing).strokes() == 2);
    const Key last = keys.next();
    CHECK(keys.at_end());
    CHECK(scene.laws(last.laws) == LawPair{});
    CHECK(scene.drawing(last.drawing).strokes() == 0);
}

TEST_CASE("steps and levels of blending are counted wherever a symbol is used")
{
    const Bytes bytes = compiled(R"(
kfast 1
canvas 64 48 frames=10
symbol both { object o fill=red stroke=white opacity=0.5 { rect 0 0 9 9 } }
symbol deep { group opacity=0.5 { use both; use both } }
object thin fill=red opacity=0.5 { rect 0 0 9 9 }
group { use deep { key 0 opacity=1; key 5 opacity=0 } }
use both opacity=1
)");
    const SceneView scene = *SceneView::parse(bytes);
    CHECK(scene.symbol_count() == 2);
    CHECK(scene.paint_steps() == 1 + (2 + 2 + 2 * (2 + 2)) + (2 + 2));
    CHECK(scene.blended_depth() == 3);
}

TEST_CASE("clips are found by their names, events are in order")
{
    const Bytes bytes = compiled(R"(
kfast 1
canvas 64 48 frames=40
clip walk from=0 to=20 loop=ping-pong
clip run from=20 to=40
event 25 later
event 3 step
object o fill=red { rect 0 0 9 9 }
)");
    const SceneView scene = *SceneView::parse(bytes);
    const auto run = scene.clip("run");
    REQUIRE(run);
    CHECK(run->begin == Time::frame(20));
    CHECK(run->end == Time::frame(40));
    CHECK(scene.clip("walk")->loop == Loop::ping_pong);
    CHECK_FALSE(scene.clip("fly"));
    EventCursor events = scene.events();
    CHECK(events.next().name == "step");
    CHECK(events.next().time == Time::frame(25));
    CHECK(events.at_end());
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

TEST_CASE("whatever a wrong writer seals is refused or can be played")
{
    std::mt19937 random{21};
    const Bytes body = body_of(compiled(everything));
    int played = 0;
    for (int round = 0; round < 1500; ++round) {
        Bytes damaged = body;
        for (auto changes = 1 + random() % 3; changes > 0; --changes)
            damaged[random() % body.size()] = static_cast<std::byte>(random());
        damaged = with_body(damaged);
        const auto scene = SceneView::parse(damaged);
        if (!scene)
            continue;
        constexpr Size panel{16, 16};
        Bytes block(Player::block_bytes(*scene, panel)); // its end is watched by the address sanitizer
        auto player = Player::create(*scene, panel, Fit::contain, block);
        REQUIRE(player);
        player->show({static_cast<std::int32_t>(random())});
        REQUIRE(player->picture().step_count <= scene->paint_steps());
        Bytes pixels(16 * 16 * 2);
        player->draw_rows<PixelFormat::rgb565>(16, pixels);
        ++played;
    }
    CHECK(played > 100);
}

}
