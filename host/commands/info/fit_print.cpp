#include "host/commands/info/fit_print.hpp"

#include "host/commands/info/fit_memory_print.hpp"
#include "host/commands/text/json_text.hpp"
#include "host/commands/text/quantity_text.hpp"
#include "host/fit/wording.hpp"
#include "host/picture/panel_choice.hpp"
#include "host/text/characters.hpp"
#include "host/text/number_text.hpp"
#include "host/words/scene_words.hpp"

#include <cmath>

namespace kfast {

namespace {

using namespace fit;

Json panel_facts(const Display& display)
{
    return {{"name", display.name},
            {"width", display.size.width},
            {"height", display.size.height},
            {"format", name_of(display.format)}};
}

Json frame_facts(const FrameCost& frame)
{
    return {{"frame", in_frames(frame.moment)},
            {"instructions", std::llround(frame.instructions)},
            {"cpu_ms", frame.cpu_seconds * 1000},
            {"bus_ms", frame.bus_seconds * 1000},
            {"bytes", frame.bytes},
            {"areas", frame.areas}};
}

Json worst_facts(const FitReport& report)
{
    Json facts = frame_facts(report.speed.worst());
    facts["object"] = report.heaviest_object;
    facts["object_share"] = report.speed.heaviest.share;
    return facts;
}

Json outline_facts(const FitReport& report)
{
    const LargestOutlines& outlines = report.speed.outlines;
    return {{"frame", in_frames(outlines.moment)},
            {"bytes", outlines.bytes},
            {"object", report.largest_object},
            {"object_bytes", outlines.item_bytes}};
}

/// null where nothing sets a limit: no frame of a still scene sends anything.
Json rate(double seconds) { return seconds > 0 ? Json(1 / seconds) : Json(nullptr); }

Json late_facts(const Lateness& late)
{
    return {{"frames", late.frames}, {"late", late.late}, {"left_out", late.left_out}};
}

Json link_facts(const std::vector<LinkUpdate>& updates)
{
    Json facts = Json::array();
    for (const LinkUpdate& update : updates)
        facts.push_back(
            {{"what", update.what}, {"reports", update.reports}, {"per_second", update.max_per_second()}});
    return facts;
}

Json facts_of(const FitFacts& facts)
{
    const auto& [file, scene, target, report] = facts;
    return {{"file", file},
            {"board", target.name},
            {"processor", target.processor_name},
            {"panel", panel_facts(target.display)},
            {"fits", report.fits()},
            {"reasons", report.reasons()},
            {"notes", report.notes},
            {"flash", flash_facts(report.flash, target.flash)},
            {"ram", ram_facts(report.ram, target.ram, "bands")},
            {"features", feature_facts(report.flash)},
            {"room", room_facts(report.flash, report.ram, target)},
            {"reserved", reserved_facts(target)},
            {"first_picture", frame_facts(report.speed.first)},
            {"median", frame_facts(report.speed.median())},
            {"worst", worst_facts(report)},
            {"noise", report.speed.noise ? frame_facts(*report.speed.noise) : Json(nullptr)},
            {"largest_outlines", outline_facts(report)},
            {"coarse_pictures", report.speed.coarse_pictures},
            {"unrecorded_bands", report.speed.unrecorded_bands},
            {"fps",
             {{"wanted", report.wanted_rate},
              {"cpu_median", rate(report.speed.by_cpu.median)},
              {"cpu_worst", rate(report.speed.by_cpu.worst)},
              {"bus_median", rate(report.speed.by_bus.median)},
              {"bus_worst", rate(report.speed.by_bus.worst)}}},
            {"late", late_facts(report.late)},
            {"late_with_inputs",
             report.late_with_inputs.frames != 0 ? late_facts(report.late_with_inputs) : Json(nullptr)},
            {"link", link_facts(report.link)}};
}

std::string time_text(const FrameCost& frame)
{
    return std::to_string(std::llround(frame.instructions)) + " instructions, " +
           milliseconds_text(frame.cpu_seconds) + "; " + bytes_text(frame.bytes) + " in " +
           milliseconds_text(frame.bus_seconds);
}

std::string limits_text(const Limits& limits)
{
    if (limits.worst <= 0)
        return "nothing to do";
    const std::string worst = rate_text(1 / limits.worst);
    const std::string median = rate_text(1 / limits.median);
    return median == worst ? worst : median + ", at worst " + worst;
}

std::string link_text(const LinkUpdate& update)
{
    return visible(update.what) + ": " + counted(update.reports, "report") + ", up to " +
           std::to_string(static_cast<int>(update.max_per_second())) + " times a second";
}

std::string verdict_text(const FitReport& report)
{
    const std::string late = report.lateness_text();
    if (!report.fits())
        return "no";
    return late.empty() ? "yes, at " + rate_text(report.wanted_rate) : "yes, but " + late;
}

std::string heaviest_text(const FitReport& report)
{
    if (report.heaviest_object.empty())
        return "";
    return "; " + visible(report.heaviest_object) + " takes " +
           std::to_string(std::lround(report.speed.heaviest.share * 100)) + " % of it";
}

}

std::string fit_text(const FitFacts& facts)
{
    const auto& [file, scene, target, report] = facts;
    const Display& display = target.display;
    const Speed& speed = report.speed;
    std::string text = file + " on " + visible(target.name) + '\n';
    text += fit_line("board", target.processor_name + " at " + frequency_text(target.clock) + ", " +
                                  std::string{display.name} + (display.name.empty() ? "" : " ") +
                                  size_text(display.size) + ' ' + std::string{name_of(display.format)} +
                                  ", bus at " + frequency_text(target.bus.clock));
    text += memory_lines(report.flash, report.ram, target, "bands");
    text += fit_line("first", time_text(speed.first));
    text += fit_line("median", time_text(speed.median()));
    text += fit_line("worst", time_text(speed.worst()));
    text += fit_line("", "frame " + frame_text(speed.worst().moment) + heaviest_text(report));
    if (speed.noise)
        text += fit_line("noise", time_text(*speed.noise));
    text += fit_line("by CPU", limits_text(speed.by_cpu));
    text += fit_line("by bus", limits_text(speed.by_bus));
    for (const LinkUpdate& update : report.link)
        text += fit_line("link", link_text(update));
    for (const std::string& note : report.notes)
        text += fit_line("note", note);
    return text + fit_line("fits", verdict_text(report));
}

std::string json_text(const FitFacts& facts) { return json_text(facts_of(facts)); }

namespace {

/// The length in widths of the field.
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
