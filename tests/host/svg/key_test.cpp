#include "tests/host/svg/drawing_text.hpp"

#include <doctest/doctest.h>

using namespace kfast;
using namespace kfast::test;

namespace {

using Box = std::vector<double>;

std::vector<double> times(const auto& animated)
{
    std::vector<double> result;
    for (const auto& key : animated.keys)
        result.push_back(key.time);
    return result;
}

std::vector<double> values(const art::Channel& channel)
{
    std::vector<double> result;
    for (const auto& key : channel.keys)
        result.push_back(std::round(key.value * 1000) / 1000);
    return result;
}

const art::Drawing& last(const art::Animated<art::Drawing>& drawing) { return drawing.keys.back().value; }

}

TEST_CASE("what is the same in all drawings is still")
{
    const auto document = read_drawings(
        {"<rect id='it' width='9' height='9'/>", "<rect id='it' width='9' height='9'/>"}, {0, 12});
    CHECK(document.frames == 12);
    CHECK(document.loop == Loop::repeat);
    CHECK(shape(document, "it").drawing.is_still());
    CHECK(find(document, "it").transform == art::Transform{});
}

TEST_CASE("what changes its form does so in its points")
{
    const auto document =
        read_drawings({"<rect id='it' width='9' height='9'/>", "<rect id='it' width='9' height='9'/>",
                       "<rect id='it' width='9' height='18'/>"},
                      {0, 6, 12});
    const auto& drawing = shape(document, "it").drawing;
    CHECK(times(drawing) == Box{0, 6, 12});
    CHECK(box(drawing.keys[1].value) == Box{0, 0, 9, 9});
    CHECK(box(last(drawing)) == Box{0, 0, 9, 18});
    CHECK_FALSE(shape(document, "it").matches_length);
    CHECK(document.loop == Loop::ping_pong);
}

TEST_CASE("forms that differ meet by length")
{
    const auto same =
        read_drawings({"<path id='it' d='M0 0v9h9z'/>", "<path id='it' d='M0 0h9v9z'/>"}, {0, 6});
    CHECK_FALSE(shape(same, "it").matches_length);
    const auto other =
        read_drawings({"<rect id='it' width='9' height='9'/>", "<path id='it' d='M0 0h9v9z'/>"}, {0, 6});
    CHECK(shape(other, "it").matches_length);
}

TEST_CASE("what only moves does so as a whole, and what turns, turns")
{
    const auto moved =
        read_drawings({"<path id='it' d='M0 0h9v9z'/>", "<path id='it' d='M10 5h9v9z'/>"}, {0, 6});
    CHECK(shape(moved, "it").drawing.is_still());
    const auto& transform = find(moved, "it").transform;
    CHECK(transform.x.at(6) - transform.x.at(0) == doctest::Approx(10));
    CHECK(transform.y.at(6) - transform.y.at(0) == doctest::Approx(5));
    CHECK(transform.rotate.is_still());

    const auto turned =
        read_drawings({"<path id='it' d='M0 0h20v4h-20z'/>", "<path id='it' d='M0 0v20h-4v-20z'/>"}, {0, 6});
    CHECK(values(find(turned, "it").transform.rotate) == Box{0, 90});
    CHECK(find(turned, "it").transform.anchor_x.value() == doctest::Approx(0));
    CHECK(find(turned, "it").transform.x.is_still());
}

TEST_CASE("rotations go the shortest way, from drawing to drawing")
{
    const auto pose = [](const std::string& angle) {
        return "<g id='arm' transform='rotate(" + angle +
               " 50 50)'><rect x='48' y='20' width='4' height='30'/></g>";
    };
    const auto document = read_drawings({pose("0"), pose("170"), pose("-170"), pose("-20")}, {0, 1, 2, 3});
    const auto& transform = find(document, "arm").transform;
    CHECK(values(transform.rotate) == Box{0, 170, 190, 340});
    CHECK(transform.anchor_x.value() == doctest::Approx(50));
    CHECK(transform.anchor_y.value() == doctest::Approx(50));
    CHECK(transform.x.is_still());
}

TEST_CASE("a group that leans passes that on to its points")
{
    const auto document =
        read_drawings({"<g id='lean'><rect id='it' width='10' height='10'/></g>",
                       "<g id='lean' transform='skewX(45)'><rect id='it' width='10' height='10'/></g>"},
                      {0, 6});
    CHECK(box(last(shape(document, "it").drawing)) == Box{0, 0, 20, 10});
}

TEST_CASE("what grows from nothing has its full size in its points")
{
    const auto document =
        read_drawings({"<g id='pop' transform='scale(0.001)'><rect id='it' width='10' height='10'/></g>",
                       "<g id='pop'><rect id='it' width='10' height='10'/></g>"},
                      {0, 6});
    CHECK(box(shape(document, "it").drawing.value()) == Box{0, 0, 10, 10});
    CHECK(values(find(document, "pop").transform.scale_x) == Box{0.001, 1});
}

TEST_CASE("colours, widths and opacities have keys of their own")
{
    const auto pose = [](const std::string& attributes) {
        return "<rect id='it' width='9' height='9' " + attributes + "/>";
    };
    const auto document = read_drawings({pose("fill='red' stroke='lime' stroke-width='1'"),
                                         pose("fill='red' stroke='blue' stroke-width='3' opacity='.5'"),
                                         pose("fill='none' stroke='blue' stroke-width='3' opacity='.5'")},
                                        {0, 6, 12});
    const auto& it = shape(document, "it");
    CHECK(it.fill->colour.is_still());
    CHECK(values(it.fill->opacity) == Box{1, 1, 0});
    CHECK(times(it.stroke->colour) == Box{0, 6});
    CHECK(values(it.stroke->width) == Box{1, 3});
    CHECK(values(find(document, "it").opacity) == Box{1, 0.5});
}

TEST_CASE("what a drawing has not is not seen until the next one that has it")
{
    const std::string with = "<rect id='it' width='9' height='9'/>";
    const auto shown = [&](const std::vector<std::string>& contents) {
        return find(read_drawings(contents, {0, 6, 12}), "it").shown;
    };
    const double forever = art::Span{}.to;
    CHECK(shown({with, with, with}) == std::vector{art::Span{}});
    CHECK(shown({with, "", with}) == std::vector{art::Span{-forever, 6}, art::Span{12, forever}});
    CHECK(shown({"", with, ""}) == std::vector{art::Span{6, 12}});
    CHECK(shown({with, with, ""}) == std::vector{art::Span{-forever, 12}});
}

TEST_CASE("what comes after the last drawing")
{
    const std::vector<std::string> poses{"<circle r='5'/>", "<circle r='9'/>"};
    const auto ended = [&](svg::Ending ending) { return read_drawings(poses, {0, 6}, {.ending = ending}); };
    CHECK(ended(svg::Ending::once).loop == Loop::once);
    CHECK(ended(svg::Ending::repeat).loop == Loop::repeat);
    CHECK(ended(svg::Ending::ping_pong).loop == Loop::ping_pong);
    CHECK(ended(svg::Ending::automatic).loop == Loop::ping_pong);
    const auto back = ended(svg::Ending::back_to_first);
    CHECK(back.loop == Loop::repeat);
    CHECK(back.frames == 12);
    CHECK(times(find(back, "circle").transform.scale_x) == Box{0, 6, 12});
}

TEST_CASE("the ease and the frame rate that were asked for")
{
    const art::Ease hold{.kind = art::EaseKind::hold};
    const auto document = read_drawings({"<circle id='it' r='5'/>", "<rect id='it' width='5' height='6'/>"},
                                        {3, 6}, {.frame_rate = 12, .ease = hold});
    CHECK(document.frame_rate == 12);
    CHECK(document.frames == 7);
    CHECK(shape(document, "it").drawing.keys.front().ease == hold);
    CHECK(shape(document, "it").drawing.keys.front().time == 3);
}

TEST_CASE("what changes but cannot is told")
{
    CHECK(losses_of_keys({"<circle id='a' r='5' stroke='red' stroke-linecap='round'/>",
                          "<circle id='a' r='5' stroke='red' stroke-linecap='butt'/>"},
                         {0, 6}) ==
          std::vector<std::string>{"change of stroke-linecap | a | as it is at first"});
    CHECK(losses_of_keys({"<circle id='a' r='5'/><g id='b'><rect id='c' width='5' height='5'/></g>",
                          "<circle id='a' r='5'/><rect id='c' width='5' height='5'/>"},
                         {0, 6})
              .size() == 1);
    CHECK(losses_of_keys({"<circle id='a' r='5'/><rect id='c' width='5' height='5'/>",
                          "<rect id='c' width='5' height='5'/><circle id='a' r='5'/>"},
                         {0, 6}) ==
          std::vector<std::string>{
              "other order of what lies over each other |  | the order of the first drawing"});
}
