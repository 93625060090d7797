#include "core/scene/scene_view.hpp"
#include "firmware/run/run.hpp"
#include "tests/compiled.hpp"

#include <doctest/doctest.h>

#include <vector>

/// The run loop with a beam instead of a panel.
namespace kfast::test {

namespace {

constexpr std::string_view moving = R"(kfast 1
canvas 100 100 fps=30 frames=10 loop=repeat
object stroke stroke=white {
    line 20 20 80 50
    key 0 x=0
    key 9 x=10
}
)";

using Picture = std::vector<BeamPoint>;

/// Goes over to a picture after it was asked so often whether it has.
class RecordedBeam {
public:
    const BeamProfile& profile() const { return profile_; }
    std::uint32_t room() const { return 500; }
    bool takes_picture() const
    {
        if (left_ > 0)
            --left_;
        return left_ == 0;
    }
    void plot(std::span<const BeamPoint> points)
    {
        REQUIRE(left_ == 0);
        plotted_.insert(plotted_.end(), points.begin(), points.end());
        REQUIRE(plotted_.size() <= room());
    }
    void show()
    {
        REQUIRE_FALSE(plotted_.empty());
        pictures.push_back(std::exchange(plotted_, {}));
        is_parked = false;
        left_ = questions;
    }
    void park()
    {
        plotted_.clear();
        is_parked = true;
        ++parks;
    }

    std::vector<Picture> pictures;
    bool is_parked = true;
    int parks = 0;
    int questions = 1; ///< until a picture has begun

private:
    BeamProfile profile_ = scope_profile;
    Picture plotted_;
    mutable int left_ = 0;
};

static_assert(Beam<RecordedBeam>);

class VectorBoard {
public:
    VectorBoard(std::span<const std::byte> scene, int frames) : frames_{frames}, scene_{scene} {}

    RecordedBeam& beam() { return beam_; }
    Microseconds now() const { return now_; }
    void sleep_until(Microseconds moment)
    {
        now_ = moment;
        if (wants_rest_)
            ++naps;
    }
    std::span<const std::byte> scene_bytes() const { return scene_; }
    std::span<std::byte> block() { return std::as_writable_bytes(std::span{block_}).first(block_bytes); }
    bool running() const { return static_cast<int>(reports.size()) < frames_; }
    void scene_started(const SceneView&) {}
    void frame_shown(FrameReport report) { reports.push_back(report); }
    void fault(Error error) { faults.push_back(error); }

    void steer(Playhead&)
    {
        wants_rest_ = rests && reports.size() == 2 && naps < 5;
        if (wants_rest_)
            was_dark = was_dark && (naps == 0 || beam_.is_parked);
    }
    bool wants_rest() const { return wants_rest_; }
    void listen() { ++listened; }

    std::vector<FrameReport> reports;
    std::vector<Error> faults;
    std::size_t block_bytes = 60'000;
    bool rests = false;
    bool was_dark = true;
    int naps = 0;
    int listened = 0;

private:
    int frames_;
    std::span<const std::byte> scene_;
    RecordedBeam beam_;
    Microseconds now_{};
    bool wants_rest_ = false;
    std::vector<std::uint32_t> block_ = std::vector<std::uint32_t>(20'000);
};

static_assert(BeamBoard<VectorBoard> && !PanelBoard<VectorBoard>);
static_assert(RestingBoard<VectorBoard> && ListeningBoard<VectorBoard>);

Picture picture_at(std::span<const std::byte> bytes, Time time)
{
    const auto scene = SceneView::parse(bytes);
    std::vector<std::uint32_t> block(BeamPlayer::block_bytes(*scene, scope_profile) / 4 + 1);
    auto player = BeamPlayer::create(*scene, scope_profile, 500, std::as_writable_bytes(std::span{block}));
    player->show_moment(time);
    Picture picture(player->report().points);
    CHECK(player->plot().next(picture) == picture.size());
    return picture;
}

}

TEST_CASE("a beam shows the points of every frame")
{
    const auto scene = compiled(moving);
    VectorBoard board{scene, 25};
    run(board);
    REQUIRE(board.beam().pictures.size() == 25);
    for (std::size_t frame = 0; frame < 25; ++frame) {
        const Time shown = Time::frame(static_cast<int>(frame % 10));
        CHECK(board.reports[frame].time == shown);
        CHECK(board.beam().pictures[frame] == picture_at(scene, shown));
    }
    CHECK(board.beam().pictures[0] != board.beam().pictures[5]);
    CHECK(board.faults.empty());
}

TEST_CASE("a beam that is not done with a picture is waited for, and the board listens meanwhile")
{
    const auto scene = compiled(moving);
    VectorBoard board{scene, 5};
    board.beam().questions = 1000;
    run(board);
    CHECK(board.beam().pictures.size() == 5);
    CHECK(board.listened >= 4 * 999);
}

TEST_CASE("a beam is dark when nothing plays any more")
{
    const auto scene = compiled(moving);
    VectorBoard board{scene, 3};
    run(board);
    CHECK(board.beam().is_parked);
}

TEST_CASE("a beam is dark when its scene cannot be played")
{
    const std::vector<std::byte> garbage(100, std::byte{0x5A});
    VectorBoard broken{garbage, 3};
    run(broken);
    CHECK(broken.beam().is_parked);
    CHECK(broken.beam().parks > 0);
    CHECK(broken.beam().pictures.empty());
    CHECK(broken.faults == std::vector{Error::bad_magic});

    const auto scene = compiled(moving);
    VectorBoard small{scene, 3};
    small.block_bytes = 8;
    run(small);
    CHECK(small.beam().pictures.empty());
    CHECK(small.faults == std::vector{Error::block_too_small});
}

TEST_CASE("a beam is dark while its board rests")
{
    const auto scene = compiled(moving);
    VectorBoard board{scene, 4};
    board.rests = true;
    run(board);
    CHECK(board.naps == 5);
    CHECK(board.was_dark);
    CHECK(board.beam().pictures.size() == 4);
}

}
