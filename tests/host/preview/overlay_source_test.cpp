#include "host/preview/overlay/overlay_source.hpp"

#include "host/beam/beam_screen_source.hpp"
#include "host/beam/profile_choice.hpp"
#include "host/picture/picture.hpp"
#include "host/preview/overlay/overlay_marks.hpp"
#include "tests/host/preview/named_scene.hpp"

#include <cmath>
#include <doctest/doctest.h>

namespace kfast::test {
namespace {

constexpr const char* two_boxes = R"(kfast 1
canvas 100 60 frames=20
group left { object a fill=red { rect 10 10 30 30 } }
object b fill=blue { rect 60 10 30 30 }
)";

template <class Mark>
std::ptrdiff_t count(const std::vector<Mark>& marks, MarkKind kind)
{
    return std::ranges::count(marks, kind, &Mark::kind);
}

}

TEST_CASE("nothing is over a picture that nobody asks for")
{
    const NamedScene scene{two_boxes};
    OverlaySource source{{scene.view(), {100, 60}}};
    const Overlay& overlay = source.show({}, {});
    CHECK((overlay.areas.empty() && overlay.lines.empty() && overlay.dots.empty() && overlay.labels.empty() &&
           overlay.facts.empty()));
}

TEST_CASE("points and strokes have numbers from 1, those of the selected item alone")
{
    const NamedScene scene{two_boxes};
    OverlaySource source{{scene.view(), {200, 120}}};
    ViewOptions view{.numbers = true};
    const Overlay all = source.show({}, view, 8);
    CHECK(count(all.dots, MarkKind::point) == 8);
    CHECK(count(all.labels, MarkKind::point) == 8);
    CHECK(count(all.labels, MarkKind::stroke) == 2);
    CHECK(count(all.lines, MarkKind::outline) == 8);
    view.selected = scene.number("left");
    const Overlay one = source.show({}, view, 8);
    CHECK(count(one.dots, MarkKind::point) == 4);
    REQUIRE(one.labels.size() == 5);
    CHECK(one.labels[0].kind == MarkKind::stroke);
    CHECK(one.labels[0].text == "1");
    CHECK(one.labels[0].at.x == 50); // in the middle of 20 … 80
    for (std::size_t i = 1; i < 5; ++i) {
        CHECK(one.labels[i].text == std::to_string(i));
        CHECK(one.labels[i].at.x == one.dots[i - 1].at.x);
        CHECK(one.labels[i].at.y == one.dots[i - 1].at.y);
    }
    view.numbers = false;
    const Overlay outline = source.show({}, view, 8);
    CHECK(outline.lines.size() == 4);
    CHECK((outline.dots.empty() && outline.labels.empty()));
}

TEST_CASE("a skeleton that carries several objects in one place is drawn once, one that carries none too")
{
    const NamedScene scene{R"(kfast 1
canvas 100 60
bones arm { bone upper 20 20 30 20 { bone lower 30 20 40 20 } }
bones tail { bone root 70 20 80 20 }
object a fill=red skin=arm bone=upper { rect 20 18 10 4 }
object b fill=red skin=arm bone=lower { rect 30 18 10 4 }
group moved y=20 { object c fill=red skin=arm bone=lower { rect 30 18 10 4 } }
object d fill=red visible=#false skin=tail bone=root { rect 70 18 10 4 }
)"};
    OverlaySource source{{scene.view(), {100, 60}}};
    const Overlay overlay = source.show({}, {.bones = true});
    REQUIRE(overlay.lines.size() == 5);
    CHECK(count(overlay.dots, MarkKind::bone) == 5);
    CHECK(overlay.lines[0].from.x == 20);
    CHECK(overlay.lines[0].to.x == 30);
    CHECK(overlay.lines[2].from.y == 40);
    CHECK(overlay.lines[4].from.x == 70);
}

TEST_CASE("changed areas come with their facts, and never on a beam")
{
    const NamedScene scene{two_boxes};
    OverlaySource source{{scene.view(), {100, 60}}};
    const Overlay overlay = source.show({}, {.changed_areas = true});
    CHECK(overlay.areas.size() == 1);
    CHECK(overlay.facts == "1 area, 12011 bytes, 100 % of the panel");
    OverlaySource beam{{.scene = scene.view(), .panel = {100, 60}, .is_beam = true}};
    CHECK(beam.show({}, {.changed_areas = true}).areas.empty());
}

TEST_CASE("what is told to inputs is seen")
{
    const NamedScene scene{"kfast 1\ncanvas 100 60\ninput gaze\n"
                           "object eye fill=red input=gaze { rect 0 0 9 9; key 0 x=0; key 1 x=20 }\n"};
    OverlaySource source{{scene.view(), {100, 60}}};
    const ViewOptions view{.selected = scene.number("eye")};
    CHECK(source.show({}, view).lines.front().from.x == 0);
    source.set_input(0, whole_input);
    CHECK(source.show({}, view).lines.front().from.x == 20);
    CHECK(source.item_at({}, {25.5, 4.5}) == scene.number("eye"));
    CHECK_FALSE(source.item_at({}, {4.5, 4.5}).has_value());
}

TEST_CASE("marks lie on the lines that a beam draws")
{
    const NamedScene scene{"kfast 1\ncanvas 100 60\nobject post stroke=lime width=1 { line 80 10 80 50 }\n"};
    const Size screen{300, 200};
    BeamScreenSource pictures{scene.view(), profile_named("scope")->profile, display_of("scope"), screen};
    const Picture picture = widen(pictures.show({}));
    OverlaySource source{{.scene = scene.view(), .panel = screen, .is_beam = true}};
    const Overlay& overlay = source.show({}, {.selected = scene.number("post")});
    REQUIRE(overlay.lines.size() == 1);
    CHECK(overlay.lines[0].from.x == overlay.lines[0].to.x);
    int brightest = 0;
    for (int x = 0; x < screen.width; ++x)
        brightest = picture.at(x, 100).green > picture.at(brightest, 100).green ? x : brightest;
    CHECK(std::abs(brightest + 0.5 - overlay.lines[0].from.x) <= 1);
}

TEST_CASE("labels keep apart, the nearer the larger the pixels, and are bounded")
{
    LabelPlaces places{2};
    CHECK(places.take({10, 10}, "1"));
    CHECK_FALSE(places.take({11, 11}, "2"));
    CHECK(places.take({30, 10}, "3"));
    LabelPlaces large{16};
    CHECK(large.take({10, 10}, "1"));
    CHECK(large.take({12, 12}, "2"));
    LabelPlaces many{100};
    std::size_t taken = 0;
    for (int i = 0; i < 1000; ++i)
        taken += many.take({i * 5.0, 0}, "7") ? 1 : 0;
    CHECK(taken == LabelPlaces::max);
}

TEST_CASE("an object with very many points has no more marks than can be told apart")
{
    std::string path = "M 0 0";
    for (int i = 0; i < 3000; ++i)
        path += " L " + std::to_string(i % 90) + ' ' + std::to_string(i % 50);
    const NamedScene scene{"kfast 1\ncanvas 100 60\nobject a stroke=red width=1 { path \"" + path +
                           "\" }\nobject b stroke=red width=1 { path \"" + path + "\" }\n"};
    OverlaySource source{{scene.view(), {100, 60}}};
    const Overlay& overlay = source.show({}, {.numbers = true});
    CHECK(overlay.dots.size() == OverlayMarks::max_dots);
    CHECK(overlay.labels.size() <= LabelPlaces::max);
}

}
