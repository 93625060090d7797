#include "host/beam/ilda_palette.hpp"
#include "host/beam/ilda_writer.hpp"
#include "host/commands/export/export_kinds.hpp"
#include "host/commands/options/report_options.hpp"
#include "host/commands/render/sound_beam.hpp"
#include "host/commands/text/work_bar.hpp"
#include "host/file/atomic_file.hpp"
#include "host/picture/film_moment.hpp"
#include "host/program/failure.hpp"
#include "host/text/counted.hpp"

#include <algorithm>
#include <iostream>

namespace kfast {
namespace {

std::vector<FilmMoment> played_moments(const Timeline& timeline)
{
    std::vector<FilmMoment> moments = film_moments(timeline);
    if (moments.size() > max_ilda_records)
        throw Failure("one play has " + counted(moments.size(), "frame") + ", more than the " +
                      std::to_string(max_ilda_records) + " of an ILDA file: play less with --clip");
    return moments;
}

struct Drawn {
    std::vector<BeamPoints> frames;
    std::size_t points = 0;
    std::size_t max_points = 0;
    std::size_t sped_up = 0;
    std::size_t incomplete = 0;
};

void add_frame(Drawn& drawn, std::span<const BeamPoint> points, const BeamReport& report)
{
    if (points.size() > max_ilda_records)
        throw Failure("frame " + std::to_string(drawn.frames.size()) + " has " +
                      std::to_string(points.size()) + " points, and an ILDA file no more than " +
                      std::to_string(max_ilda_records) + " in a frame: draw it coarser with another --beam");
    drawn.frames.emplace_back(points.begin(), points.end());
    drawn.points += points.size();
    drawn.max_points = std::max(drawn.max_points, points.size());
    drawn.sped_up += report.speed_level > 0;
    drawn.incomplete += !report.is_complete;
}

Drawn drawn_frames(BeamSource& source, const Timeline& timeline)
{
    Drawn drawn;
    const std::vector<FilmMoment> moments = played_moments(timeline);
    WorkBar bar{"drawing"};
    for (const FilmMoment& moment : moments) {
        bar.report(drawn.frames.size(), moments.size());
        add_frame(drawn, source.show(moment.time), source.report());
    }
    return drawn;
}

void report(const std::filesystem::path& output, const Drawn& drawn, std::uint32_t rate, std::ostream& out)
{
    out << output.string() << ": " << counted(drawn.frames.size(), "frame") << ", "
        << counted(drawn.points, "point") << ", at most " << drawn.max_points << " in a frame ("
        << rate / std::max<std::size_t>(drawn.max_points, 1) << " times a second at " << rate
        << " points a second)\n";
    if (drawn.sped_up > 0)
        std::cerr
            << "kfast: " << counted(drawn.sped_up, "frame")
            << " had to be drawn faster than the profile has it, in longer steps: mirrors may not follow; "
               "draw fewer lines, or choose a profile with a lower least-refresh\n";
    if (drawn.incomplete > 0)
        std::cerr << "kfast: " << counted(drawn.incomplete, "frame")
                  << " had no time for all lines: a profile with a lower least-refresh gives more\n";
}

void report_colours(const Drawn& drawn, IldaFormat format)
{
    if (is_indexed(format) && IldaPalette{drawn.frames}.is_too_small())
        std::cerr << "kfast: there are more colours than a palette has, and some become the nearest one: "
                     "--ilda-format 5 or 4 has all\n";
}

}

void export_ilda(const ExportOptions& options)
{
    const SceneFile scene = load_scene(options.scene);
    const Timeline timeline = chosen_timeline(options.play, scene.view);
    const std::filesystem::path output = export_path(options, ".ild");
    BeamSource source =
        open_beam(options.beam.value_or(galvo_profile), max_ilda_records, options.picture, scene);
    const Drawn drawn = drawn_frames(source, timeline);
    const std::string name = std::filesystem::path{options.scene}.stem().string();
    const auto format = static_cast<IldaFormat>(options.ilda_format);
    write_file(output, ilda_file(name, format, drawn.frames));
    report(output, drawn, source.profile().rate, report_stream(options.quiet));
    report_colours(drawn, format);
}

}
