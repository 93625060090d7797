#pragma once

#include "host/picture/timeline.hpp"
#include "host/preview/files/frame_collection.hpp"

#include <atomic>
#include <filesystem>
#include <future>

namespace kfast {

/// Writes a GIF without holding up who waits for it: frame by frame it is drawn, and then written by another
/// thread, from the frames alone. Stopped by its end.
class GifWriting {
public:
    GifWriting(std::filesystem::path target, const Timeline& timeline);
    ~GifWriting();
    GifWriting(const GifWriting&) = delete;
    GifWriting& operator=(const GifWriting&) = delete;

    const std::filesystem::path& target() const { return target_; }
    std::size_t frames() const { return frames_.total(); }
    /// Draws one frame, or waits a little for the other thread. True once the file is written. Throws Failure
    /// when it cannot be; then there is none.
    bool go_on(FrameSource& source);
    int percent() const;

private:
    std::filesystem::path target_;
    Timeline timeline_;
    FrameCollection frames_;
    std::atomic<std::size_t> written_ = 0; ///< frames that were looked at
    std::atomic<bool> is_stopped_ = false;
    std::future<void> written_all_;
};

}
