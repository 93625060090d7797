#include "host/picture/video.hpp"

#include "host/file/atomic_file.hpp"
#include "host/picture/film.hpp"
#include "host/picture/picture.hpp"
#include "host/program/failure.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <deque>
#include <fcntl.h>
#include <numeric>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace kfast {

namespace {

constexpr int output_number = 3; ///< of the descriptor in the program
constexpr std::size_t max_lines = 8;

Failure not_made(const std::filesystem::path& target, const std::string& reason)
{
    return Failure("cannot make " + target.string() + ": " + reason);
}

/// What a program inherits from this one.
class Inheritance {
public:
    Inheritance()
    {
        ::posix_spawn_file_actions_init(&actions);
        ::posix_spawnattr_init(&attributes);
        sigset_t default_signals;
        ::sigemptyset(&default_signals);
        ::sigaddset(&default_signals, SIGPIPE);
        ::posix_spawnattr_setsigdefault(&attributes, &default_signals);
        ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    }
    ~Inheritance()
    {
        ::posix_spawn_file_actions_destroy(&actions);
        ::posix_spawnattr_destroy(&attributes);
    }
    Inheritance(const Inheritance&) = delete;
    Inheritance& operator=(const Inheritance&) = delete;

    void give(int descriptor, int number)
    {
        ::posix_spawn_file_actions_adddup2(&actions, descriptor, number);
    }

    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
};

std::vector<char*> argument_list(const std::vector<std::string>& words)
{
    std::vector<char*> list;
    list.reserve(words.size() + 1);
    for (const std::string& word : words)
        list.push_back(const_cast<char*>(word.c_str())); // posix_spawn() leaves them as they are
    list.push_back(nullptr);
    return list;
}

}

VideoPipe::IgnoredPipeSignal::IgnoredPipeSignal() : before_{std::signal(SIGPIPE, SIG_IGN)} {}

VideoPipe::IgnoredPipeSignal::~IgnoredPipeSignal() { std::signal(SIGPIPE, before_); }

VideoPipe::VideoPipe(std::filesystem::path target, int descriptor, const Command& command)
    : target_{std::move(target)}, messages_{std::tmpfile(), std::fclose}
{
    std::array<int, 2> ends{};
    if (messages_ == nullptr || ::pipe2(ends.data(), O_CLOEXEC) != 0)
        throw not_made(target_, std::strerror(errno));
    pipe_ = ends[1];
    // Under this name the program opens the very file, whatever its path and name are now.
    const std::vector<std::string> words = command("/dev/fd/" + std::to_string(output_number));
    try {
        start(ends[0], descriptor, words);
    } catch (...) {
        ::close(ends[0]);
        ::close(pipe_);
        throw;
    }
    ::close(ends[0]);
}

VideoPipe::~VideoPipe()
{
    if (program_ > 0) {
        ::kill(program_, SIGKILL);
        wait();
    }
    if (pipe_ >= 0)
        ::close(pipe_);
}

void VideoPipe::start(int input, int descriptor, const std::vector<std::string>& words)
{
    Inheritance inheritance;
    inheritance.give(input, STDIN_FILENO);
    inheritance.give(::fileno(messages_.get()), STDOUT_FILENO);
    inheritance.give(::fileno(messages_.get()), STDERR_FILENO);
    inheritance.give(descriptor, output_number);
    const int error = ::posix_spawnp(&program_, words.front().c_str(), &inheritance.actions,
                                     &inheritance.attributes, argument_list(words).data(), environ);
    if (error == 0)
        return;
    program_ = -1;
    if (error == ENOENT)
        throw not_made(target_, "there is no program " + words.front() + ": install it (apt install " +
                                    words.front() + "), or make an .apng or a .gif, which need none");
    throw not_made(target_, words.front() + " does not start: " + std::strerror(error));
}

void VideoPipe::write(std::span<const std::byte> bytes)
{
    while (!bytes.empty()) {
        const ssize_t written = ::write(pipe_, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR)
            fail();
        bytes = bytes.subspan(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
    }
}

void VideoPipe::finish()
{
    ::close(std::exchange(pipe_, -1));
    const int status = wait();
    // It may end well and have reported that it could not write all.
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || has_messages())
        throw not_made(target_, "ffmpeg failed" + messages_text());
}

int VideoPipe::wait()
{
    int status = 0;
    while (::waitpid(program_, &status, 0) < 0 && errno == EINTR)
        continue;
    program_ = -1;
    return status;
}

/// It reads no more.
void VideoPipe::fail()
{
    ::close(std::exchange(pipe_, -1));
    wait();
    throw not_made(target_, "ffmpeg ended before it had all pictures" + messages_text());
}

bool VideoPipe::has_messages() const
{
    std::fseek(messages_.get(), 0, SEEK_END);
    return std::ftell(messages_.get()) > 0;
}

std::string VideoPipe::messages_text() const
{
    std::rewind(messages_.get());
    std::string all;
    std::array<char, 4096> block{};
    while (const std::size_t count = std::fread(block.data(), 1, block.size(), messages_.get()))
        all.append(block.data(), count);
    std::istringstream lines{all};
    std::deque<std::string> last;
    for (std::string line; std::getline(lines, line);) {
        last.push_back(std::move(line));
        if (last.size() > max_lines)
            last.pop_front();
    }
    std::string text = last.empty() ? ", and told nothing" : ". It told:";
    for (const std::string& line : last)
        text += "\n    " + line;
    return text;
}

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

/// Colours as HD video has them, which is also declared in the file: players guess otherwise.
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
