#pragma once

#include "host/picture/frame_source.hpp"
#include "host/picture/timeline.hpp"
#include "host/program/progress_callback.hpp"

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <sys/types.h>
#include <vector>

namespace kfast {

/// A run of the program ffmpeg that reads pictures from a pipe and writes an open file. No shell is involved.
/// One at a time: while it lives, SIGPIPE is ignored.
class VideoPipe {
public:
    /// The words of the command, its name first, for a program that finds its file under this name.
    using Command = std::function<std::vector<std::string>(const std::string& output)>;

    /// `target` is what messages call the file, `descriptor` is open for writing and outlives the pipe.
    /// Throws Failure when there is no such program.
    VideoPipe(std::filesystem::path target, int descriptor, const Command& command);
    /// Ends the program if finish() did not.
    ~VideoPipe();
    VideoPipe(const VideoPipe&) = delete;
    VideoPipe& operator=(const VideoPipe&) = delete;

    /// Throws Failure, with the last lines that the program printed, when it has ended.
    void write(std::span<const std::byte> bytes);
    /// Waits for the program. Throws Failure as write() does unless it ended well.
    void finish();

private:
    using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

    /// To write what nobody reads is an error then, and does not end this program.
    class IgnoredPipeSignal {
    public:
        IgnoredPipeSignal();
        ~IgnoredPipeSignal();
        IgnoredPipeSignal(const IgnoredPipeSignal&) = delete;
        IgnoredPipeSignal& operator=(const IgnoredPipeSignal&) = delete;

    private:
        void (*before_)(int);
    };

    void start(int input, int descriptor, const std::vector<std::string>& words);
    int wait();
    [[noreturn]] void fail();
    bool has_messages() const;
    std::string messages_text() const;

    std::filesystem::path target_;
    IgnoredPipeSignal ignored_;
    File messages_;
    int pipe_ = -1;
    pid_t program_ = -1;
};

enum class VideoKind { mp4, webm };

/// Whether a picture gets another column and row: H.264 as players know it has sides of even length.
bool is_padded(Size size);

/// Writes `loops` periods of what is played, at least one, with the program ffmpeg: H.264 in MP4, VP9 in
/// WebM, every frame of the scene as one of the video. A side of odd length becomes one pixel longer, like
/// its neighbour. Throws Failure when there is no ffmpeg, or with the last of its output when it fails;
/// then there is no file.
void write_video(const std::filesystem::path& target, VideoKind kind, FrameSource& source,
                 const Timeline& timeline, int loops, const ProgressCallback& on_progress = ignore_progress);

}
