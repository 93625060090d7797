#include "host/picture/player_source.hpp"

#include "host/compiler/write/header.hpp"
#include "tests/compiled.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace kfast::test {

TEST_CASE("a source tells when outlines find no room, and the least detail so far")
{
    std::vector<std::byte> bytes = compiled(R"(
kfast 1
canvas 60 60 frames=8
object dots fill=white {
    key 0 { circle 10 10 r=9 }
    key 4 { circle 10 10 r=9; circle 30 30 r=9; circle 50 50 r=9 }
})");
    const auto details = [&bytes] {
        PlayerSource source{*SceneView::parse(bytes), {60, 60}, Fit::contain, PixelFormat::rgb565};
        std::vector<Detail> found;
        std::vector<std::string> texts;
        for (const int frame : {0, 4, 0}) {
            source.show(Time::frame(frame));
            found.push_back(source.min_detail());
            texts.push_back(source.facts());
        }
        CHECK(texts[0].empty());
        CHECK(texts[2].empty());
        CHECK(found[0] == Detail::full);
        CHECK(found[1] == found[2]);
        CHECK(texts[1].empty() == (found[1] == Detail::full));
        return std::pair{found[1], texts[1]};
    };
    const std::uint32_t enough = SceneView::parse(bytes)->outline_bytes();
    CHECK(details() == std::pair{Detail::full, std::string{}});
    std::pair<Detail, std::string> last{Detail::full, ""};
    bool was_coarse = false;
    for (std::uint32_t room = enough / 4 * 4; last.first != Detail::parts_missing; room -= 16) {
        set_outline_needs(bytes, {.bytes = room, .borders = 200});
        const auto next = details();
        CHECK(next.first <= last.first);
        was_coarse = was_coarse || next.first == Detail::coarse;
        last = next;
    }
    CHECK(was_coarse);
    CHECK(last.second == "parts are missing, for want of room");
    const CoarsePictures pictures = coarse_pictures(*SceneView::parse(bytes), {60, 60}, 100);
    CHECK(pictures.looked_at == 8);
    CHECK(pictures.coarse > 0);
    CHECK(pictures.coarse < 8);
    CHECK(coarse_pictures(*SceneView::parse(bytes), {60, 60}, 1).looked_at == 1);
    CHECK(coarse_pictures(*SceneView::parse(bytes), {60, 60}, 1).coarse == 0); // that of frame 0
}

}
