#include "host/preview/board/fit_check.hpp"

#include <atomic>
#include <exception>
#include <thread>
#include <utility>

namespace kfast {

/// Whoever reads the lines waits for is_done_; until then they are the thread's.
class FitCheck::Work {
public:
    Work(std::span<const std::byte> scene, std::vector<std::string> item_names, fit::Target board, Fit fit)
        : scene_{scene.begin(), scene.end()}, item_names_{std::move(item_names)}, board_{std::move(board)},
          fit_{fit}, thread_{[this](const std::stop_token& stop) { run(stop); }}
    {
    }

    std::optional<std::span<const FitLine>> lines() const
    {
        if (!is_done_)
            return {};
        return lines_;
    }

private:
    void run(const std::stop_token& stop)
    {
        try {
            lines_ = made_lines(stop);
            is_done_ = true;
        } catch (const fit::FitStopped&) {
            return;                               // nobody asks any more
        } catch (const std::exception& failure) { // such as no memory: nobody else would catch it
            lines_ = {{failure.what(), FitLine::Verdict::bad}};
            is_done_ = true;
        }
    }

    std::vector<FitLine> made_lines(const std::stop_token& stop) const
    {
        const SceneView scene = *SceneView::parse(scene_);
        if (board_.beam)
            return fit_lines(fit::beam_fit(scene, board_, 0, stop), board_);
        return fit_lines(
            fit::fit_report(
                {.scene = scene, .item_names = item_names_, .target = board_, .fit = fit_, .stop = stop}),
            board_);
    }

    std::vector<std::byte> scene_;
    std::vector<std::string> item_names_;
    fit::Target board_;
    Fit fit_;
    std::vector<FitLine> lines_;
    std::atomic<bool> is_done_ = false;
    std::jthread thread_; ///< last: it uses all the others
};

FitCheck::FitCheck(std::span<const std::byte> scene, std::vector<std::string> item_names, fit::Target board,
                   Fit fit)
    : work_{new Work{scene, std::move(item_names), std::move(board), fit}}
{
}

FitCheck::~FitCheck() = default;

std::optional<std::span<const FitLine>> FitCheck::lines() const { return work_->lines(); }

}
