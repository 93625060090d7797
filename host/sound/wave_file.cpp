#include "host/sound/wave_file.hpp"

#include "host/program/failure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <sndfile.h>
#include <stdexcept>
#include <string>

namespace kfast {

namespace {

constexpr std::size_t slow_tours = 8; ///< they divide what is left over at the end
constexpr double milli = 1000;

/// Ticks of the scene's time.
double ticks_per_sample(const Timeline& timeline, std::uint32_t rate)
{
    return timeline.frame_rate / milli * Time::ticks_per_frame / rate;
}

class LoopMaker {
public:
    LoopMaker(BeamSource& source, const Timeline& timeline, std::uint64_t samples)
        : source_{source}, timeline_{timeline}, samples_{samples}, step_{source.profile().travel_step}
    {
    }

    SoundLoop make(const ProgressCallback& on_progress)
    {
        while (add_tour())
            on_progress(loop_.points.size(), samples_);
        if (pieces_.empty())
            throw std::length_error("a picture takes more points than the sound has samples");
        append(travel(loop_.points.back(), loop_.points.front(), step_));
        fill();
        return std::move(loop_);
    }

private:
    /// The frame of the scene that is due at the end of the samples so far.
    std::int64_t due_frame() const
    {
        const auto samples = static_cast<std::int64_t>(loop_.points.size());
        return samples * timeline_.frame_rate / (std::int64_t{1000} * source_.profile().rate);
    }

    void show(std::int64_t frame)
    {
        if (frame == frame_)
            return;
        frame_ = frame;
        tour_ = tour_of(source_.show(timeline_.shown_at(frame * Time::ticks_per_frame)));
    }

    /// Returns false if it has no room, with the return to the beginning after it.
    bool add_tour()
    {
        show(due_frame());
        const bool is_first = loop_.points.empty();
        const Tour way = is_first ? Tour{} : travel(loop_.points.back(), tour_.front(), step_);
        const Tour back = travel(tour_.back(), is_first ? tour_.front() : loop_.points.front(), step_);
        if (loop_.points.size() + way.size() + tour_.size() + back.size() > samples_)
            return false;
        append(way);
        pieces_.push_back(loop_.points.size());
        append(tour_);
        count_tour();
        return true;
    }

    void append(const Tour& tour) { loop_.points.insert(loop_.points.end(), tour.begin(), tour.end()); }

    void count_tour()
    {
        ++loop_.tours;
        loop_.sped_up_tours += source_.report().speed_level > 0;
        loop_.incomplete_tours += !source_.report().is_complete;
    }

    /// Makes the last tours slower, all alike.
    void fill()
    {
        const std::size_t slow = std::min(slow_tours, pieces_.size());
        const std::size_t first = pieces_[pieces_.size() - slow];
        const Tour last{loop_.points.begin() + static_cast<std::ptrdiff_t>(first), loop_.points.end()};
        const FieldPoint beginning = loop_.points.front();
        loop_.points.resize(first);
        append(stretched(last, beginning, samples_ - first));
    }

    BeamSource& source_;
    const Timeline& timeline_;
    std::uint64_t samples_;
    std::uint32_t step_;
    SoundLoop loop_;
    std::vector<std::size_t> pieces_; ///< where the tours begin
    std::int64_t frame_ = -1;         ///< the one that `tour_` shows
    Tour tour_;
};

}

std::uint64_t sound_length(const Timeline& timeline, std::uint32_t rate)
{
    const std::int64_t held = timeline.stretch.loop == Loop::once ? Time::ticks_per_frame : 0;
    const double ticks = static_cast<double>(timeline.period_ticks() + held);
    return static_cast<std::uint64_t>(std::llround(ticks / ticks_per_sample(timeline, rate)));
}

SoundLoop sound_loop(BeamSource& source, const Timeline& timeline, std::uint64_t samples,
                     const ProgressCallback& on_progress)
{
    return LoopMaker{source, timeline, samples}.make(on_progress);
}

double longest_step(const Tour& tour)
{
    double longest = distance(tour.back(), tour.front());
    for (std::size_t at = 1; at < tour.size(); ++at)
        longest = std::max(longest, distance(tour[at - 1], tour[at]));
    return longest;
}

FieldPoint mean_place(const Tour& tour)
{
    std::int64_t x = 0;
    std::int64_t y = 0;
    for (const FieldPoint point : tour) {
        x += point.x;
        y += point.y;
    }
    const auto mean = [&tour](std::int64_t sum) {
        return static_cast<std::int16_t>(
            std::llround(static_cast<double>(sum) / static_cast<double>(tour.size())));
    };
    return {mean(x), mean(y)};
}

namespace {

constexpr int channels = 2;
constexpr std::size_t block = 4096; ///< samples that are written at once

/// A file in memory, as libsndfile requires it: it goes back to the header at the end.
struct MemoryFile {
    std::vector<std::byte> bytes;
    std::size_t at = 0;
};

MemoryFile& memory(void* file) { return *static_cast<MemoryFile*>(file); }

sf_count_t size(void* file) { return static_cast<sf_count_t>(memory(file).bytes.size()); }

sf_count_t tell(void* file) { return static_cast<sf_count_t>(memory(file).at); }

sf_count_t seek(sf_count_t offset, int whence, void* file)
{
    const sf_count_t from = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? tell(file) : size(file);
    memory(file).at = static_cast<std::size_t>(std::max<sf_count_t>(from + offset, 0));
    return tell(file);
}

sf_count_t read(void* to, sf_count_t count, void* file)
{
    MemoryFile& from = memory(file);
    const std::size_t max = from.bytes.size() - std::min(from.at, from.bytes.size());
    const std::size_t taken = std::min(static_cast<std::size_t>(count), max);
    std::memcpy(to, from.bytes.data() + from.at, taken);
    from.at += taken;
    return static_cast<sf_count_t>(taken);
}

sf_count_t write(const void* from, sf_count_t count, void* file)
{
    MemoryFile& to = memory(file);
    const auto bytes = std::span{static_cast<const std::byte*>(from), static_cast<std::size_t>(count)};
    to.bytes.resize(std::max(to.bytes.size(), to.at + bytes.size()));
    std::ranges::copy(bytes, to.bytes.begin() + static_cast<std::ptrdiff_t>(to.at));
    to.at += bytes.size();
    return count;
}

struct Close {
    void operator()(SNDFILE* file) const { sf_close(file); }
};

/// libsndfile cuts off the bits that a file has no room for.
int rounded(std::int32_t level, int bits)
{
    const std::int64_t unit = std::int64_t{1} << (32 - bits);
    const std::int64_t max = std::numeric_limits<std::int32_t>::max() - (unit - 1);
    return static_cast<int>(std::min((level + unit / 2) & -unit, max));
}

void write_points(SNDFILE* file, std::span<const FieldPoint> points, const Deflection& deflection, int bits)
{
    std::array<int, channels * block> levels;
    int* end = levels.data();
    for (const FieldPoint point : points) {
        const StereoSample sample = deflection.sample(point);
        *end++ = rounded(sample.left, bits);
        *end++ = rounded(sample.right, bits);
    }
    const auto count = static_cast<sf_count_t>(points.size());
    if (sf_writef_int(file, levels.data(), count) != count)
        throw Failure(std::string("cannot make the WAV: ") + sf_strerror(file));
}

}

std::vector<std::byte> wave_file(std::span<const FieldPoint> points, const Deflection& deflection,
                                 std::uint32_t rate, int bits)
{
    SF_INFO info{};
    info.samplerate = static_cast<int>(rate);
    info.channels = channels;
    info.format = SF_FORMAT_WAV | (bits == 24 ? SF_FORMAT_PCM_24 : SF_FORMAT_PCM_16);
    SF_VIRTUAL_IO in_memory{size, seek, read, write, tell};
    MemoryFile target;
    std::unique_ptr<SNDFILE, Close> file{sf_open_virtual(&in_memory, SFM_WRITE, &info, &target)};
    if (file == nullptr)
        throw Failure(std::string("cannot make the WAV: ") + sf_strerror(nullptr));
    for (; !points.empty(); points = points.subspan(std::min(block, points.size())))
        write_points(file.get(), points.first(std::min(block, points.size())), deflection, bits);
    file.reset();
    return std::move(target.bytes);
}

}
