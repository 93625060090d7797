#include "host/preview/fit_lines.hpp"

#include "host/fit/wording.hpp"
#include "host/text/glyph.hpp"

#include <cmath>
#include <sstream>

namespace kfast {
namespace {

using Verdict = FitLine::Verdict;

Verdict verdict(bool is_good) { return is_good ? Verdict::good : Verdict::bad; }

/// Broken between words, further lines indented.
void add_sentence(const std::string& text, Verdict verdict, std::vector<FitLine>& lines)
{
    std::istringstream words{text};
    std::string line;
    for (std::string word; words >> word;) {
        if (!line.empty() && line.size() + 1 + word.size() > FitLine::most_letters) {
            lines.push_back({line, verdict});
            line.assign(1, ' ');
        }
        line.append(line.empty() ? "" : " ").append(word);
    }
    lines.push_back({line, verdict});
}

void add_sentences(const std::vector<std::string>& texts, Verdict verdict, std::vector<FitLine>& lines)
{
    for (const std::string& text : texts)
        add_sentence(text, verdict, lines);
}

/// "flash   61 of 2048 KiB", rounded up.
FitLine memory_line(const std::string& name, std::size_t used, std::size_t available)
{
    constexpr std::size_t kibibyte = 1024;
    return {name + std::to_string((used + kibibyte - 1) / kibibyte) + " of " +
                std::to_string(available / kibibyte) + " KiB",
            verdict(used <= available)};
}

/// The reserves are those of the rest of the board's program.
void add_memory(const fit::FlashNeed& flash, const fit::RamNeed& ram, const fit::Target& board,
                std::vector<FitLine>& lines)
{
    lines.push_back({"scene   " + fit::bytes_text(flash.scene)});
    lines.push_back({"needs   " + fit::bytes_text(ram.block) + " of RAM"});
    lines.push_back(memory_line("flash   ", flash.sum(), board.flash));
    lines.push_back(memory_line("RAM     ", ram.sum(), board.ram));
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

void add_speed(const fit::FitReport& report, std::vector<FitLine>& lines)
{
    const fit::FrameCost& median = report.speed.median();
    const fit::FrameCost& worst = report.speed.worst();
    lines.push_back(
        {"speed   " + fit::rate_text(1 / median.seconds()) + ", wanted " + fit::rate_text(report.wanted_rate),
         verdict(report.slowness.empty())});
    lines.push_back({"median  " + time_text(median)});
    lines.push_back({"worst   " + time_text(worst)});
    lines.push_back({"        frame " + fit::frame_text(worst.moment)});
    if (!report.heaviest_object.empty())
        add_sentence(visible(report.heaviest_object) + " takes " +
                         std::to_string(std::lround(report.speed.heaviest.share * 100)) + " % of it",
                     Verdict::neutral, lines);
    if (worst.seconds() > 0)
        lines.push_back({worst.bus_seconds > worst.cpu_seconds ? "limit   the bus" : "limit   the CPU"});
}

/// The verdict and why, then what is true anyway.
std::vector<FitLine> beginning(bool fits, const std::vector<std::string>& reasons, const fit::Target& board)
{
    std::vector<FitLine> lines{{fits ? "fits" : "does not fit", verdict(fits)}};
    add_sentences(reasons, Verdict::bad, lines);
    lines.push_back({clock_text(board)});
    return lines;
}

}

std::vector<FitLine> fit_lines(const fit::FitReport& report, const fit::Target& board)
{
    std::vector<FitLine> lines = beginning(report.fits(), report.reasons(), board);
    lines.push_back({panel_text(board.display)});
    add_memory(report.flash, report.ram, board, lines);
    add_speed(report, lines);
    add_sentences(report.notes, Verdict::neutral, lines);
    return lines;
}

std::vector<FitLine> fit_lines(const fit::BeamFit& report, const fit::Target& board)
{
    const fit::BeamMoment& busiest = report.busiest();
    std::vector<FitLine> lines = beginning(report.fits(), report.reasons(), board);
    lines.push_back({std::to_string(board.beam->rate) + " points a second"});
    add_memory(report.flash, report.ram, board, lines);
    lines.push_back({"mean    " + std::to_string(std::lround(report.mean_points())) + " points"});
    lines.push_back({"busiest " + std::to_string(busiest.report.points) + " points, frame " +
                     fit::frame_text(busiest.moment)});
    lines.push_back({"        drawn " + std::to_string(std::lround(fit::refresh(busiest, *board.beam))) +
                     " times a second"});
    lines.push_back({"CPU     " + fit::milliseconds_text(report.dearest_seconds) + " for a new picture"});
    add_sentences(report.notes, Verdict::neutral, lines);
    return lines;
}

}
