#pragma once

#include "host/picture/frame_source.hpp"
#include "host/picture/timeline.hpp"

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <future>
#include <string>
#include <string_view>
#include <vector>

namespace kfast {

/// The name of a new file that is made of the scene in `scene`: "eyes" + `suffix` + `extension` beside it,
/// with
/// "-2", "-3" ... after the suffix where there is one already. It is in the current folder if none can be
/// written there, and begins with "scene" if that is no regular file.
std::filesystem::path new_output_name(const std::filesystem::path& scene, const std::string& suffix,
                                      const std::string& extension);

/// "-0012"
std::string frame_suffix(int frame);

/// A part of a name as it may be in that of a file: what would need quotes in a shell is "_".
std::string plain_name(std::string_view name);

/// The pictures at several times, drawn one by one and kept.
class FrameCollection {
public:
    /// The maximum of a collection; more is not acceptable in the memory of a computer that has other things
    /// to do.
    static constexpr std::size_t max_bytes = std::size_t{1} << 30;

    explicit FrameCollection(std::vector<Time> moments);

    std::size_t total() const { return moments_.size(); }
    std::size_t done() const { return frames_.size(); }
    bool is_complete() const { return done() == total(); }
    /// Draws the next one; there must be one left.
    void add_next(FrameSource& source);
    struct Drawn {
        Frame frame;
        std::string facts; ///< FrameSource::facts()
    };
    /// Null where that time was not drawn.
    const Drawn* at(Time moment) const;

private:
    std::vector<Time> moments_;
    std::vector<Drawn> frames_; ///< at the first times
};

/// Writes a GIF without blocking the caller: frame by frame it is drawn, and then written by another
/// thread, from the frames alone. The destructor stops it.
class GifWriting {
public:
    GifWriting(std::filesystem::path target, const Timeline& timeline);
    ~GifWriting();
    GifWriting(const GifWriting&) = delete;
    GifWriting& operator=(const GifWriting&) = delete;

    const std::filesystem::path& target() const { return target_; }
    std::size_t frames() const { return frames_.total(); }
    /// Draws one frame, or waits a little for the other thread. Returns true once the file is written. Throws
    /// Failure when it cannot be; then there is none.
    bool go_on(FrameSource& source);
    int percent() const;

private:
    std::filesystem::path target_;
    Timeline timeline_;
    FrameCollection frames_;
    std::atomic<std::size_t> written_ = 0; ///< frames that were processed
    std::atomic<bool> is_stopped_ = false;
    std::future<void> written_all_;
};

}
