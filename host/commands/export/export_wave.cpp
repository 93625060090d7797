#include "host/commands/export/export_kinds.hpp"
#include "host/commands/options/report_options.hpp"
#include "host/commands/render/sound_beam.hpp"
#include "host/commands/text/work_bar.hpp"
#include "host/file/atomic_file.hpp"
#include "host/program/failure.hpp"
#include "host/sound/sound_loop.hpp"
#include "host/sound/wave_file.hpp"
#include "host/text/counted.hpp"
#include "host/text/rounded_text.hpp"

#include <cmath>
#include <iostream>
#include <stdexcept>

namespace kfast {
namespace {

/// 21 minutes at 48 kHz: much less than a WAV can hold, but it takes memory.
constexpr std::uint64_t max_samples = 60'000'000;
constexpr std::uint64_t min_samples = 16; ///< BeamPlayer needs room for so many points

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
