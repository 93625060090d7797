#include "host/preview/overlay/overlay_source.hpp"

#include "host/picture/picture.hpp"
#include "host/picture/player_source.hpp"
#include "tests/host/preview/named_scene.hpp"

#include <array>
#include <doctest/doctest.h>
#include <memory>

namespace kfast::test {
namespace {

constexpr std::array<std::string_view, 5> names{"plate", "ring", "leaf", "blade", "lid"};

/// Without the item of that number; none is left out if there is no such item. An item that is left out is
/// hidden, so that the scene stays the same otherwise.
std::string scene_text(std::size_t left_out)
{
    const auto shown = [left_out](std::size_t item) {
        return std::string(item == left_out ? " visible=#false" : "");
    };
    return "kfast 1\ncanvas 48 36 frames=20 background=black\n"
           "symbol bush { object leaf fill=lime" +
           shown(2) + " { rect 0 0 12 9 } }\n" + "object plate fill=red" + shown(0) +
           " { circle 18 18 r=15 }\n" + "object ring stroke=blue width=5" + shown(1) +
           " { circle 24 16 r=11 }\n" +
           "group turned rotate=20 x=4 { use bush x=8 y=4; object blade fill=yellow" + shown(3) +
           " { path \"M 20 0 L 30 4 L 24 30 Z\" } }\n" + "object lid fill=white" + shown(4) +
           " { key 0 x=0; key 20 x=30; rect 4 22 10 8 }\n";
}

Picture rendered(const NamedScene& scene, Time moment)
{
    PlayerSource source{scene.view(), {96, 72}, Fit::contain, PixelFormat::rgb666};
    return widen(source.show(moment));
}

/// Which of the names is at each pixel; their number where none is.
std::vector<std::size_t> items_at(const NamedScene& scene, Time moment)
{
    OverlaySource source{{scene.view(), {96, 72}}};
    std::vector<std::size_t> items;
    for (int y = 0; y < 72; ++y)
        for (int x = 0; x < 96; ++x) {
            const auto item = source.item_at(moment, {x + 0.5, y + 0.5});
            const auto found = item ? std::ranges::find(names, scene.names()[*item]) : names.end();
            items.push_back(static_cast<std::size_t>(found - names.begin()));
        }
    return items;
}

/// Whether another item is at one of the eight pixels around it, or it lies at the edge of the panel.
bool is_edge(const std::vector<std::size_t>& items, std::size_t at)
{
    if (at < 97 || at + 97 >= items.size())
        return true;
    for (const std::size_t row : {at - 96, at, at + 96})
        if (items[row - 1] != items[at] || items[row] != items[at] || items[row + 1] != items[at])
            return true;
    return false;
}

}

TEST_CASE("an item is at a place exactly where the picture without it differs, but for edges")
{
    const NamedScene whole{scene_text(names.size())};
    for (const Time moment : {Time::frame(0), Time::frame(11)}) {
        const Picture picture = rendered(whole, moment);
        const std::vector<std::size_t> items = items_at(whole, moment);
        std::array<int, names.size() + 1> counts{};
        for (std::size_t left_out = 0; left_out < names.size(); ++left_out) {
            CAPTURE(names[left_out]);
            const NamedScene scene{scene_text(left_out)};
            const Picture without = rendered(scene, moment);
            int wrong = 0;
            for (std::size_t at = 0; at < items.size(); ++at) {
                if (is_edge(items, at))
                    continue;
                counts[left_out] += items[at] == left_out ? 1 : 0;
                wrong += (items[at] == left_out) == (picture.pixels[at] == without.pixels[at]) ? 1 : 0;
            }
            CHECK(wrong == 0);
            CHECK(counts[left_out] > 50);
        }
    }
}

TEST_CASE("nothing is beside the panel, and a thin line is where nothing else is")
{
    const NamedScene scene{
        "kfast 1\ncanvas 20 20\nobject hair stroke=red width=0.25 { line 0 10.5 20 10.5 }\n"};
    OverlaySource source{{scene.view(), {20, 20}}};
    CHECK(source.item_at({}, {5.5, 10.5}) == scene.number("hair"));
    CHECK_FALSE(source.item_at({}, {5.5, 12.5}).has_value());
    for (const PanelSpot beside :
         {PanelSpot{-0.5, 10.5}, PanelSpot{20, 10.5}, PanelSpot{5, -3}, PanelSpot{5, 99}})
        CHECK_FALSE(source.item_at({}, beside).has_value());
}

TEST_CASE("on the screen of a beam the nearest outline counts")
{
    const NamedScene scene{"kfast 1\ncanvas 100 100\nobject box stroke=lime width=1 { rect 20 20 60 60 }\n"
                           "object bar stroke=lime width=1 { line 0 50 100 50 }\n"};
    const Viewport viewport{.scene = scene.view(), .panel = {200, 200}, .is_beam = true};
    OverlaySource source{viewport};
    const PanelSpot left = viewport.spot({Fixed::pixels(205), Fixed::pixels(400)}); // of 1024
    CHECK(source.item_at({}, {left.x + 2, left.y}) == scene.number("box"));
    CHECK(source.item_at({}, {100, 102}) == scene.number("bar"));
    CHECK_FALSE(source.item_at({}, {100, 80}).has_value());
}

}
