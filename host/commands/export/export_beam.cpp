#include "host/beam/ilda_format.hpp"
#include "host/beam/ilda_writer.hpp"
#include "host/commands/export/export_kinds.hpp"
#include "host/commands/options/output_options.hpp"
#include "host/commands/render/picture_options.hpp"
#include "host/commands/text/progress.hpp"
#include "host/file/atomic_file.hpp"
#include "host/picture/film.hpp"
#include "host/program/failure.hpp"
#include "host/sound/wave_file.hpp"
#include "host/text/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <stdexcept>

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

namespace {

/// 21 minutes at 48 kHz: much less than a WAV can hold, but it takes memory.
constexpr std::uint64_t max_samples = 60'000'000;
constexpr std::uint64_t min_samples = 16; ///< BeamPlayer needs room for that many points

std::uint64_t chosen_length(const ExportOptions& options, const Timeline& timeline)
{
    const std::uint32_t rate = options.sound.rate;
    const std::uint64_t length = options.seconds
                                     ? static_cast<std::uint64_t>(std::llround(*options.seconds * rate))
                                     : sound_length(timeline, rate);
    if (length > max_samples)
        throw Failure("this takes " + std::to_string(length) + " samples, more than the " +
                      std::to_string(max_samples) +
                      " that kfast writes: choose a lower --sample-rate, less --seconds or a --clip");
    if (length < min_samples)
        throw Failure("one play is too short for a sound: make it longer with --seconds");
    return length;
}

SoundLoop made_loop(BeamSource& source, const Timeline& timeline, std::uint64_t length)
try {
    WorkBar bar{"drawing"};
    return sound_loop(source, timeline, length, bar.callback());
} catch (const std::length_error& reason) {
    throw Failure(std::string{reason.what()} + ": make it longer with --seconds");
}

std::string percent(std::int16_t place) { return rounded_text(std::round(place * 1000.0 / field_side) / 10); }

void report(const SoundLoop& loop, std::uint32_t rate, std::ostream& out)
{
    const auto samples = static_cast<double>(loop.points.size());
    const FieldPoint mean = mean_place(loop.points);
    out << rounded_text(samples / rate) << " s, " << counted(loop.tours, "tour") << ", "
        << rounded_text(std::round(static_cast<double>(loop.tours) * rate / samples))
        << " a second, middle at " << percent(mean.x) << " % " << percent(mean.y) << " %\n";
    if (loop.sped_up_tours > 0)
        std::cerr << "kfast: " << counted(loop.sped_up_tours, "tour")
                  << " had to be drawn faster and coarser: a higher --sample-rate draws finer\n";
    if (loop.incomplete_tours > 0)
        std::cerr << "kfast: " << counted(loop.incomplete_tours, "tour")
                  << " had no time for all lines: a higher --sample-rate gives more\n";
}

}

void export_wave(const ExportOptions& options)
{
    const SceneFile scene = load_scene(options.scene);
    const Timeline timeline = chosen_timeline(options.play, scene.view);
    const std::filesystem::path output = export_path(options, ".wav");
    const std::uint64_t length = chosen_length(options, timeline);
    BeamSource source = open_beam(sound_beam(options.beam, options.sound.rate),
                                  static_cast<std::uint32_t>(length), options.picture, scene);
    const SoundLoop loop = made_loop(source, timeline, length);
    const std::uint32_t rate = options.sound.rate;
    write_file(output, wave_file(loop.points, options.sound.deflection, rate, options.bits));
    std::ostream& out = report_stream(options.quiet);
    out << output.string() << ": ";
    report(loop, rate, out);
}

}
