#include "host/picture/video.hpp"

#include "host/file/atomic_file.hpp"
#include "host/picture/channel_bytes.hpp"
#include "host/picture/film_moment.hpp"
#include "host/picture/picture_part.hpp"
#include "host/picture/video_pipe.hpp"

#include <numeric>

namespace kfast {
namespace {

constexpr int even(int side) { return side + side % 2; }

/// The last column and row once more where a side is odd.
Picture padded(const Picture& picture)
{
    const Size size = picture.size;
    Picture result = plain_picture(even(size.width), even(size.height), {}, "the video");
    put(part(picture, {size.width - 1, 0, 1, size.height}), result, result.size.width - 1, 0);
    put(picture, result, 0, 0);
    put(part(result, {0, size.height - 1, result.size.width, 1}), result, 0, result.size.height - 1);
    return result;
}

/// "30", "2997/100"
std::string rate_text(std::uint32_t frame_rate)
{
    const std::uint32_t common = std::gcd(frame_rate, 1000U);
    const std::string whole = std::to_string(frame_rate / common);
    return common == 1000 ? whole : whole + '/' + std::to_string(1000 / common);
}

/// Colours as HD video has them, which is also what the file says: players guess otherwise.
std::vector<std::string> encoder(VideoKind kind)
{
    std::vector<std::string> words{"-vf",
                                   "scale=out_color_matrix=bt709",
                                   "-pix_fmt",
                                   "yuv420p",
                                   "-colorspace",
                                   "bt709",
                                   "-color_primaries",
                                   "bt709",
                                   "-color_trc",
                                   "iec61966-2-1"};
    const std::vector<std::string> own =
        kind == VideoKind::mp4
            ? std::vector<std::string>{"-c:v",      "libx264",    "-crf", "16",
                                       "-movflags", "+faststart", "-f",   "mp4"}
            : std::vector<std::string>{"-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-f", "webm"};
    words.insert(words.end(), own.begin(), own.end());
    return words;
}

std::vector<std::string> arguments(VideoKind kind, Size size, std::uint32_t frame_rate,
                                   const std::string& output)
{
    std::vector<std::string> words{
        "ffmpeg",      "-hide_banner",
        "-loglevel",   "error",
        "-xerror",     "-nostats",
        "-f",          "rawvideo",
        "-pix_fmt",    "rgb24",
        "-video_size", std::to_string(size.width) + 'x' + std::to_string(size.height),
        "-framerate",  rate_text(frame_rate),
        "-i",          "pipe:0"};
    for (const std::string& word : encoder(kind))
        words.push_back(word);
    words.insert(words.end(), {"-y", output});
    return words;
}

}

bool is_padded(Size size) { return size.width % 2 != 0 || size.height % 2 != 0; }

void write_video(const std::filesystem::path& target, VideoKind kind, FrameSource& source,
                 const Timeline& timeline, int loops, const ProgressCallback& on_progress)
{
    const std::vector<FilmMoment> moments = film_moments(timeline);
    const Picture first = padded(widen(source.show(moments.front().time)));
    AtomicFile file{target};
    VideoPipe pipe{target, file.descriptor(), [&](const std::string& output) {
                       return arguments(kind, first.size, timeline.frame_rate, output);
                   }};
    const std::size_t total = moments.size() * static_cast<std::size_t>(loops);
    for (std::size_t done = 0; done < total; ++done) {
        on_progress(done, total);
        pipe.write(channel_bytes(padded(widen(source.show(moments[done % moments.size()].time)))));
    }
    pipe.finish();
    file.commit();
}

}
