#include "host/fit/beam_fit.hpp"

#include "host/fit/cost_table.hpp"
#include "host/fit/scene_run.hpp"
#include "host/fit/speed.hpp"
#include "host/fit/wording.hpp"
#include "host/text/number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace kfast::fit {
namespace {

constexpr std::size_t point_bytes = 4;
constexpr double bits_of_point = 2 * 17; ///< two words of an MCP4922, and a pause between them
constexpr int readable_speed_level = 4;  ///< beyond twice the speed, lines grow too dark or too coarse

/// The size of the program that plays for a beam, with the core (tests/bench/image/beam).
constexpr std::size_t beam_code = 78272;

/// Instructions of the Cortex-M0 besides those that evaluating a scene takes on panels: fitted to the results
/// of scripts/bench_beam for 12 examples, within 15 %. To plot a picture, as often as one is shown; and to
/// clip its lines, count them and put them in order, where it is not the one before.
constexpr double per_plotted_corner = 490;
constexpr double per_plotted_point = 120;
constexpr double per_new_corner = 290;
constexpr double per_further_line = 13000;
constexpr double per_compared_travel = 53;

/// Others of the same family need about two thirds of them (docs/benchmarks.md).
double share_of(Processor processor) { return processor == Processor::cortex_m0 ? 1 : 2.0 / 3; }

double instructions_of(const BeamPicture& picture, const Target& target)
{
    const BeamReport& report = picture.report;
    double beam = per_plotted_corner * report.corners + per_plotted_point * report.points;
    if (picture.is_new())
        beam += per_new_corner * report.corners + per_compared_travel * report.compared +
                per_further_line * std::max<double>(report.lines, 1) - per_further_line;
    return instructions(picture.work, costs_of(target.processor)) + beam * share_of(target.processor);
}

RamNeed ram_for_beam(const SceneView& scene, const Target& target)
{
    RamNeed need = ram_need(scene, target);
    need.block = BeamPlayer::block_bytes(scene, *target.beam);
    return need;
}

void check_memory(const std::string& what, std::size_t used, std::size_t available, const std::string& parts,
                  std::vector<std::string>& shortages)
{
    if (used > available)
        shortages.push_back(what + ": " + bytes_text(used) + " are needed (" + parts + "), " +
                            std::to_string(available) + " are there: " + std::to_string(used - available) +
                            " too many");
}

void check_bus(const Target& target, std::vector<std::string>& weaknesses)
{
    const double max = std::floor(target.bus.clock / bits_of_point);
    if (target.beam->rate > max)
        weaknesses.push_back("bus: it takes " + std::to_string(static_cast<std::uint32_t>(max)) +
                             " points a second, but the beam has " + std::to_string(target.beam->rate) +
                             "; choose a lower rate= or a faster clock=");
}

void check_pictures(const BeamFit& fit, const Target& target, std::vector<std::string>& weaknesses)
{
    if (fit.incomplete == 0)
        return;
    const auto first =
        std::ranges::find_if(fit.pictures, [](const BeamMoment& it) { return !it.report.is_complete; });
    weaknesses.push_back("lines: " + counted(fit.incomplete, "picture") + " of " +
                         std::to_string(fit.pictures.size()) + " cannot be drawn whole, that of frame " +
                         frame_text(first->moment) +
                         " for one; draw fewer lines, or choose a lower least-refresh= (" +
                         std::to_string(target.beam->min_refresh) + " now) or a higher rate=");
}

void check_speed(const BeamFit& fit, std::vector<std::string>& weaknesses)
{
    std::vector<double> seconds;
    std::ranges::transform(fit.pictures, std::back_inserter(seconds), &BeamMoment::cpu_seconds);
    std::ranges::sort(seconds);
    const double median = seconds[seconds.size() / 2];
    if (median * fit.wanted_rate > slack)
        weaknesses.push_back("speed: every second picture takes " + milliseconds_text(median) +
                             " or more, but " + rate_text(fit.wanted_rate) + " leave " +
                             milliseconds_text(1 / fit.wanted_rate) + " for each; " + rate_text(1 / median) +
                             " can be reached");
}

void check_watchdog(const BeamFit& fit, const Target& target, std::vector<std::string>& weaknesses)
{
    const auto dearest = std::ranges::max_element(fit.pictures, {}, &BeamMoment::cpu_seconds);
    if (const std::string reason = watchdog_reason(dearest->cpu_seconds, dearest->moment, target);
        !reason.empty())
        weaknesses.push_back(reason);
}

/// About pictures that are drawn completely: the others are a reason not to fit.
void note_speed_level(const BeamFit& fit, std::vector<std::string>& notes)
{
    int max = 0;
    std::size_t sped_up = 0;
    for (const BeamMoment& picture : fit.pictures)
        if (picture.report.is_complete && picture.report.speed_level > 0) {
            ++sped_up;
            max = std::max<int>(max, picture.report.speed_level);
        }
    if (sped_up == 0)
        return;
    std::array<char, 16> factor{};
    std::snprintf(factor.data(), factor.size(), "%.1f", std::exp2(max / 4.0));
    notes.push_back(counted(sped_up, "picture") + " of " + std::to_string(fit.pictures.size()) +
                    " are drawn faster than the profile has it, up to " + factor.data() +
                    " times: lines are darker" +
                    (max > readable_speed_level ? " and corners less sharp; draw fewer lines" : ""));
}

void note_hatchings(const BeamFit& fit, std::vector<std::string>& notes)
{
    const auto widened = [](const BeamMoment& picture) { return picture.report.wider_hatchings != 0; };
    const auto count = static_cast<std::size_t>(std::ranges::count_if(fit.pictures, widened));
    if (count != 0)
        notes.push_back(counted(count, "picture") + " of " + std::to_string(fit.pictures.size()) +
                        (count == 1 ? " has" : " have") +
                        " hatchings with wider spaces than told, as there is no room for all of their "
                        "lines: take a larger hatch=, or hatch less");
}

void note_room(const Target& target, std::vector<std::string>& notes)
{
    const std::uint32_t room = room_for_points(target);
    const std::uint32_t wanted = target.beam->rate / std::max<std::uint32_t>(target.beam->min_refresh, 1);
    if (room < wanted)
        notes.push_back("a buffer holds " + std::to_string(room) + " points, but the beam has time for " +
                        std::to_string(wanted) + " in a picture");
}

}

std::uint32_t room_for_points(const Target& target)
{
    return static_cast<std::uint32_t>(std::max<std::size_t>(target.band_bytes / point_bytes, 16));
}

std::vector<std::string> BeamFit::reasons() const
{
    std::vector<std::string> all = shortages;
    all.insert(all.end(), weaknesses.begin(), weaknesses.end());
    return all;
}

double BeamFit::mean_points() const
{
    double sum = 0;
    for (const BeamMoment& picture : pictures)
        sum += picture.report.points;
    return sum / static_cast<double>(pictures.size());
}

double refresh(const BeamMoment& picture, const BeamProfile& profile)
{
    return static_cast<double>(profile.rate) / picture.report.points;
}

BeamFit beam_fit(const SceneView& scene, const Target& target, double frames_per_second,
                 const std::stop_token& stop, const ProgressCallback& on_progress)
{
    const double cycles = target.cycles != 0 ? target.cycles : costs_of(target.processor).cycles;
    BeamFit fit;
    fit.flash = {beam_code, scene.size(), target.reserved_flash()};
    fit.ram = ram_for_beam(scene, target);
    fit.wanted_rate = frames_per_second != 0 ? frames_per_second : scene.frame_rate() / 1000.0;
    BeamRun run{scene, target};
    run.visit_all([&](const BeamPicture& picture) {
        go_on(stop);
        on_progress(fit.pictures.size(), run.frames_of_all());
        const double count = instructions_of(picture, target);
        fit.pictures.push_back({picture.moment, picture.report, count, count * cycles / target.clock});
        fit.sped_up += picture.report.speed_level != 0 ? 1 : 0;
        fit.incomplete += picture.report.is_complete ? 0 : 1;
        fit.dearest_seconds = std::max(fit.dearest_seconds, fit.pictures.back().cpu_seconds);
    });
    std::ranges::stable_sort(fit.pictures, {},
                             [](const BeamMoment& picture) { return picture.report.points; });
    check_memory("flash", fit.flash.sum(), target.flash, parts_text(fit.flash), fit.shortages);
    check_memory("RAM", fit.ram.sum(), target.ram, parts_text(fit.ram, "buffers"), fit.shortages);
    check_bus(target, fit.weaknesses);
    check_pictures(fit, target, fit.weaknesses);
    check_watchdog(fit, target, fit.weaknesses);
    check_speed(fit, fit.weaknesses);
    note_speed_level(fit, fit.notes);
    note_hatchings(fit, fit.notes);
    note_room(target, fit.notes);
    if (run.stride() > 1)
        fit.notes.push_back("the scene is long: one frame of " + std::to_string(run.stride()) +
                            " was looked at");
    return fit;
}

}
