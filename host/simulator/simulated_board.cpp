#include "host/simulator/simulated_board.hpp"

#include "core/player.hpp"
#include "firmware/run/run.hpp"
#include "host/program/failure.hpp"

namespace kfast {

namespace {

template <Panel P>
class BoardSource : public FrameSource {
public:
    BoardSource(std::span<const std::byte> scene, const PanelSettings& settings)
        : board_{scene, settings, 0},
          player_{
              *Player::create(*SceneView::parse(scene), board_.panel().size(), Fit::contain, board_.block())}
    {
        begin_panel(board_);
        light_panel(board_); // nothing is seen before the first picture
    }
    BoardSource(const BoardSource&) = delete;

    const Frame& show(Time moment) override
    {
        player_.show_moment(moment);
        draw_frame(board_, player_);
        if (const auto mistake = board_.bus_error())
            throw Failure("the simulated panel was driven wrongly: " + *mistake);
        frame_ = board_.picture();
        detail_.add(player_.picture());
        return frame_;
    }
    bool set(std::uint32_t number, const InputContent& content) override
    {
        return give_input(player_, number, content);
    }
    std::string facts() const override { return detail_.text(); }
    Detail min_detail() const override { return detail_.min(); }
    Pace pace() const override { return Pace::by_frames; }

private:
    SimulatedBoard<P> board_;
    Player player_;
    Frame frame_;
    ShownDetail detail_;
};

}

std::unique_ptr<FrameSource> open_board_source(std::span<const std::byte> scene,
                                               const PanelSettings& settings)
{
    return with_driver<SimulatedBus>(settings.controller, [&]<Panel P>() -> std::unique_ptr<FrameSource> {
        return std::make_unique<BoardSource<P>>(scene, settings);
    });
}

}
