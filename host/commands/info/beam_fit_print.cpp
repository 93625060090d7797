#include "host/commands/info/beam_fit_print.hpp"

#include "host/commands/info/fit_memory_print.hpp"
#include "host/commands/text/json_text.hpp"
#include "host/fit/wording.hpp"
#include "host/text/counted.hpp"
#include "host/text/glyph.hpp"
#include "host/words/in_frames.hpp"

#include <cmath>

namespace kfast {
namespace {

using namespace fit;

/// How often as wide as the field.
double fields(std::uint64_t length) { return static_cast<double>(length) / field_side; }

Json picture_facts(const BeamMoment& picture, const BeamProfile& profile)
{
    const BeamReport& report = picture.report;
    return {{"frame", in_frames(picture.moment)},
            {"points", report.points},
            {"lit_points", report.lit_points},
            {"refresh", refresh(picture, profile)},
            {"lit", fields(report.lit_length)},
            {"travel", fields(report.blanked_length)},
            {"lines", report.lines},
            {"corners", report.corners},
            {"speed", std::exp2(report.speed_level / 4.0)},
            {"complete", report.is_complete},
            {"instructions", std::llround(picture.instructions)},
            {"cpu_ms", picture.cpu_seconds * 1000}};
}

Json facts_of(const BeamFitFacts& facts)
{
    const auto& [file, target, report] = facts;
    return {{"file", file},
            {"board", target.name},
            {"processor", target.processor_name},
            {"beam",
             {{"rate", target.beam->rate},
              {"least_refresh", target.beam->min_refresh},
              {"resolution", target.beam->resolution},
              {"laser", target.beam->is_laser}}},
            {"fits", report.fits()},
            {"reasons", report.reasons()},
            {"notes", report.notes},
            {"flash", flash_facts(report.flash, target.flash)},
            {"ram", ram_facts(report.ram, target.ram, "buffers")},
            {"room", room_facts(report.flash, report.ram, target)},
            {"reserved", reserved_facts(target)},
            {"busiest", picture_facts(report.busiest(), *target.beam)},
            {"median", picture_facts(report.pictures[report.pictures.size() / 2], *target.beam)},
            {"mean_points", report.mean_points()},
            {"pictures", report.pictures.size()},
            {"hasty", report.sped_up},
            {"incomplete", report.incomplete},
            {"fps", {{"wanted", report.wanted_rate}, {"cpu_worst", 1 / report.dearest_seconds}}}};
}

std::string one_digit(double number)
{
    const auto tenths = std::llround(number * 10);
    return std::to_string(tenths / 10) + '.' + std::to_string(tenths % 10);
}

std::string points_text(const BeamMoment& picture, const BeamProfile& profile)
{
    return counted(picture.report.points, "point") + ", drawn " + one_digit(refresh(picture, profile)) +
           " times a second";
}

std::string way_text(const BeamMoment& picture)
{
    const BeamReport& report = picture.report;
    return "frame " + frame_text(picture.moment) + "; " + counted(report.lines, "line") + ", " +
           one_digit(fields(report.lit_length)) + " widths of the field lit, " +
           one_digit(fields(report.blanked_length)) + " blanked";
}

}

std::string fit_text(const BeamFitFacts& facts)
{
    const auto& [file, target, report] = facts;
    const BeamProfile& profile = *target.beam;
    std::string text = file + " on " + visible(target.name) + '\n';
    text += fit_line("board", target.processor_name + " at " + frequency_text(target.clock) + ", a beam of " +
                                  std::to_string(profile.rate) + " points a second");
    text += memory_lines(report.flash, report.ram, target, "buffers");
    text += fit_line("mean", one_digit(report.mean_points()) + " points");
    text += fit_line("busiest", points_text(report.busiest(), profile));
    text += fit_line("", way_text(report.busiest()));
    text += fit_line("by CPU", "new pictures at " + rate_text(1 / report.dearest_seconds) +
                                   ", the dearest in " + milliseconds_text(report.dearest_seconds));
    for (const std::string& note : report.notes)
        text += fit_line("note", note);
    return text + fit_line("fits", report.fits() ? "yes" : "no");
}

std::string json_text(const BeamFitFacts& facts) { return json_text(facts_of(facts)); }

}
