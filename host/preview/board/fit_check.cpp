#include "host/preview/board/fit_check.hpp"

#include "host/fit/wording.hpp"
#include "host/text/characters.hpp"

#include <atomic>
#include <cmath>
#include <exception>
#include <thread>
#include <utility>

namespace kfast {

namespace {

using Verdict = FitLine::Verdict;

Verdict verdict(bool is_valid) { return is_valid ? Verdict::good : Verdict::bad; }

void add_sentences(const std::vector<std::string>& texts, Verdict verdict, std::vector<FitLine>& lines)
{
    for (const std::string& text : texts)
        lines.push_back({text, verdict});
}

/// "scene   310 B of 256 KiB"
FitLine memory_line(const std::string& name, std::size_t used, std::size_t room)
{
    return {name + fit::memory_text(used) + " of " + fit::memory_text(room), verdict(used <= room)};
}

/// Adds what the scene takes of the room for scenes.
void add_scene_memory(const fit::FlashNeed& flash, const fit::RamNeed& ram, const fit::Target& board,
                      std::vector<FitLine>& lines)
{
    lines.push_back(memory_line("RAM     ", ram.block, ram.room(board.ram)));
    lines.push_back(memory_line("scene   ", flash.scene, flash.room(board.flash)));
}

/// Adds what the firmware takes besides.
void add_firmware_memory(const fit::FlashNeed& flash, const fit::RamNeed& ram, const fit::Target& board,
                         std::vector<FitLine>& lines)
{
    const auto add = [&lines](const char* name, std::size_t used, std::size_t available) {
        lines.push_back({name + fit::memory_text(used) + " of " + fit::memory_text(available)});
    };
    lines.push_back({"besides, the firmware has"});
    add("RAM     ", ram.sum() - ram.block, board.ram);
    add("flash   ", flash.sum() - flash.scene, board.flash);
}

std::string clock_text(const fit::Target& board)
{
    return board.name + ", " + fit::frequency_text(board.clock);
}

std::string time_text(const fit::FrameCost& frame)
{
    return fit::milliseconds_text(frame.cpu_seconds) + " CPU, " + fit::milliseconds_text(frame.bus_seconds) +
           " bus";
}

std::string panel_text(const fit::Display& display)
{
    return std::string{display.name} + ' ' + std::to_string(display.size.width) + 'x' +
           std::to_string(display.size.height);
}

void add_rate(const fit::FitReport& report, std::vector<FitLine>& lines)
{
    lines.push_back({"speed   " + fit::rate_text(1 / report.speed.median().seconds()) + ", wanted " +
                         fit::rate_text(report.wanted_rate),
                     verdict(report.slowness.empty() && report.hang.empty())});
}

void add_times(const fit::FitReport& report, std::vector<FitLine>& lines)
{
    const fit::FrameCost& worst = report.speed.worst();
    lines.push_back({"median  " + time_text(report.speed.median())});
    lines.push_back({"worst   " + time_text(worst)});
    lines.push_back({"        frame " + fit::frame_text(worst.moment)});
    if (!report.heaviest_object.empty())
        lines.push_back({visible(report.heaviest_object) + " takes " +
                         std::to_string(std::lround(report.speed.heaviest.share * 100)) + " % of it"});
    if (worst.seconds() > 0)
        lines.push_back({worst.bus_seconds > worst.cpu_seconds ? "limit   the bus" : "limit   the CPU"});
}

std::vector<FitLine> beginning(bool fits, const fit::Target& board)
{
    return {{fits ? "fits" : "does not fit", verdict(fits)}, {clock_text(board)}};
}

}

std::vector<FitLine> fit_lines(const fit::FitReport& report, const fit::Target& board)
{
    std::vector<FitLine> lines = beginning(report.fits(), board);
    if (const std::string late = report.lateness_text(); report.fits() && !late.empty()) {
        lines.front().verdict = Verdict::neutral;
        lines.insert(lines.begin() + 1, {"but " + late});
    }
    lines.push_back({panel_text(board.display)});
    add_rate(report, lines);
    add_scene_memory(report.flash, report.ram, board, lines);
    add_times(report, lines);
    add_firmware_memory(report.flash, report.ram, board, lines);
    add_sentences(report.reasons(), Verdict::bad, lines);
    add_sentences(report.notes, Verdict::neutral, lines);
    return lines;
}

std::vector<FitLine> fit_lines(const fit::BeamFit& report, const fit::Target& board)
{
    const fit::BeamMoment& busiest = report.busiest();
    std::vector<FitLine> lines = beginning(report.fits(), board);
    lines.push_back({std::to_string(board.beam->rate) + " points a second"});
    lines.push_back({"busiest " + std::to_string(busiest.report.points) + " points, frame " +
                     fit::frame_text(busiest.moment)});
    lines.push_back({"        drawn " + std::to_string(std::lround(fit::refresh(busiest, *board.beam))) +
                     " times a second"});
    add_scene_memory(report.flash, report.ram, board, lines);
    lines.push_back({"mean    " + std::to_string(std::lround(report.mean_points())) + " points"});
    lines.push_back({"CPU     " + fit::milliseconds_text(report.dearest_seconds) + " for a new picture"});
    add_firmware_memory(report.flash, report.ram, board, lines);
    add_sentences(report.reasons(), Verdict::bad, lines);
    add_sentences(report.notes, Verdict::neutral, lines);
    return lines;
}

/// Readers of the lines wait for is_done_; until then they are the thread's.
class FitCheck::Work {
public:
    Work(std::span<const std::byte> scene, std::vector<std::string> item_names, fit::Target board, Fit fit)
        : scene_{scene.begin(), scene.end()},
          item_names_{std::move(item_names)},
          board_{std::move(board)},
          fit_{fit},
          thread_{[this](const std::stop_token& stop) { run(stop); }}
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
