#include "host/sound/wave_file.hpp"

#include "host/program/failure.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <sndfile.h>
#include <string>

namespace kfast {
namespace {

constexpr int channels = 2;
constexpr std::size_t block = 4096; ///< samples that are written at once

/// A file in memory, as libsndfile asks for it: it goes back to the header at the end.
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

/// libsndfile cuts off what a file has no bits for.
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
