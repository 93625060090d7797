#include "host/preview/board/board_changes.hpp"

#include "firmware/run/run.hpp"
#include "host/fit/board_choice.hpp"
#include "host/preview/board/previewed_board.hpp"
#include "host/simulator/simulated_board.hpp"
#include "tests/host/preview/named_scene.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

/// A driver that notes what it is told to send.
template <Panel P>
class NotingPanel : public P {
public:
    using P::P;

    void start(Rect area, std::span<const std::byte> pixels)
    {
        areas.push_back(area);
        bytes += pixels.size() + static_cast<std::size_t>(P::window_bytes);
        P::start(area, pixels);
    }

    std::vector<Rect> areas;
    std::size_t bytes = 0;
};

constexpr const char* ball = R"(kfast 1
canvas 128 64 frames=30 background="#102030"
object floor fill=green { rect 0 50 128 14 }
object ball fill=red { key 0 x=0 y=0; key 20 x=80 y=20; key 30 x=80 y=20; circle 20 20 r=9 }
object lamp fill=white { key 0 fill=white law=hold; key 25 fill=yellow; circle 110 12 r=6 }
)";

constexpr std::size_t simulated_rows = 8; ///< in a band

/// Board by board: frames in order, one that is shown again, leaps.
template <Panel P>
void check_against_simulator(Controller controller)
{
    const NamedScene scene{ball};
    SimulatedBoard<NotingPanel<P>> board{scene.bytes(), facts_of(controller).default_value, 0};
    const Size panel = board.panel().size();
    Player player = *Player::create(scene.view(), panel, Fit::contain, board.block());
    begin_panel(board);
    fit::Target target = previewed_board({.size = panel, .controller = controller_name(controller)});
    CHECK(target.display.format == P::format);
    target.band_bytes = simulated_rows * row_bytes(P::format, panel.width);
    BoardChanges changes{scene.view(), target, Fit::contain};
    for (const int ticks : {0, 1024, 2048, 2500, 9000, 20'480, 25'600, 26'000, 3000}) {
        CAPTURE(ticks);
        board.panel().areas.clear();
        board.panel().bytes = 0;
        player.show_moment({ticks});
        draw_frame(board, player);
        REQUIRE_FALSE(board.bus_error().has_value());
        const SentAreas& sent = changes.show({ticks});
        CHECK(sent.areas == board.panel().areas);
        CHECK(sent.bytes == board.panel().bytes);
    }
}

}

TEST_CASE("what is told to be sent is what a board sends to its panel")
{
    check_against_simulator<DcsPanel<SimulatedBus>>(Controller::st7789);
    check_against_simulator<Ssd1306<SimulatedBus>>(Controller::ssd1306);
}

TEST_CASE("a moment that is asked for again is told the same, and the first one comes after the frame before")
{
    const NamedScene scene{ball};
    const fit::Target board = previewed_board({.size = {128, 64}});
    BoardChanges played{scene.view(), board, Fit::contain};
    CHECK(played.show({}).areas == std::vector<Rect>{{0, 0, 128, 60}, {0, 60, 128, 4}});
    CHECK(played.show({}).bytes == 128 * 64 * 2 + 2 * 11);
    for (int frame = 1; frame < 7; ++frame)
        played.show(Time::frame(frame));
    const std::vector<Rect> areas = played.show(Time::frame(7)).areas;
    CHECK_FALSE(areas.empty());
    CHECK(played.show(Time::frame(7)).areas == areas);
    BoardChanges opened{scene.view(), board, Fit::contain};
    CHECK(opened.show(Time::frame(7)).areas == areas);
    CHECK(played.show(Time::frame(22)).areas != areas);
    CHECK(played.show(Time::frame(23)).areas.empty());
}

TEST_CASE("an input that is told makes changes at the same moment")
{
    const NamedScene scene{"kfast 1\ncanvas 128 64\ninput gaze\n"
                           "object eye fill=red input=gaze { circle 9 9 r=5; key 0 x=0; key 1 x=20 }\n"};
    BoardChanges changes{scene.view(), previewed_board({.size = {128, 64}}), Fit::contain};
    changes.show({});
    changes.set_input(0, whole_input);
    const std::vector<Rect> areas = changes.show({}).areas;
    CHECK_FALSE(areas.empty());
    CHECK(areas != std::vector<Rect>{{0, 0, 128, 60}, {0, 60, 128, 4}});
    CHECK(changes.show({}).areas == areas);
}

TEST_CASE("the share of the panel is rounded to nearest, but more than nothing")
{
    SentAreas sent{{{0, 0, 10, 10}}, 211};
    CHECK(sent.text({100, 100}) == "1 area, 211 bytes, 1 % of the panel");
    sent.areas = {{0, 0, 1, 1}, {5, 5, 2, 2}};
    CHECK(sent.text({100, 100}) == "2 areas, 211 bytes, 1 % of the panel");
    sent.areas = {{0, 0, 100, 55}};
    CHECK(sent.text({100, 100}) == "1 area, 211 bytes, 55 % of the panel");
    CHECK(SentAreas{}.text({100, 100}) == "0 areas, 0 bytes, 0 % of the panel");
}

}
