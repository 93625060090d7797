#pragma once

#include "host/beam/beam_source.hpp"
#include "host/picture/timeline.hpp"
#include "host/program/progress_callback.hpp"
#include "host/sound/deflection.hpp"
#include "host/sound/tour.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kfast {

/// How a scene became a wave. Steps are in units of the field.
struct SoundLoop {
    Tour points; ///< after the last one comes the first one
    std::size_t tours = 0;
    std::size_t sped_up_tours = 0;    ///< whose pictures are drawn faster than in the profile
    std::size_t incomplete_tours = 0; ///< whose pictures lack lines
};

/// The samples of one play, rounded to the nearest: with ping-pong there and back, and for what plays
/// once the end is held for a frame.
std::uint64_t sound_length(const Timeline& timeline, std::uint32_t rate);

/// A wave of exactly `samples` samples, `source`'s profile having so many a second as it has points. Each
/// picture is toured until the next frame of the scene is due, and to the end of that tour, so that frames
/// never come more than a tour late. Between pictures the beam travels as in the profile. The last tours
/// are a little slower, so that their end meets the beginning.
///
/// Throws std::length_error if not one tour has room, which a budget of `samples` prevents.
SoundLoop sound_loop(BeamSource& source, const Timeline& timeline, std::uint64_t samples,
                     const ProgressCallback& on_progress = ignore_progress);

/// The longest step of a closed tour.
double longest_step(const Tour& tour);

/// The middle of all points, by the time that the beam is there: what a sound card with coupling capacitors
/// moves to the middle of the screen. In units of the field, rounded.
FieldPoint mean_place(const Tour& tour);

/// A WAV file in which these points are played, `rate` a second. `bits` are 16 or 24; levels are rounded.
/// Throws Failure if libsndfile cannot write it.
std::vector<std::byte> wave_file(std::span<const FieldPoint> points, const Deflection& deflection,
                                 std::uint32_t rate, int bits);

}
