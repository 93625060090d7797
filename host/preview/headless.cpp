#include "host/preview/headless.hpp"

#include "core/crc32.hpp"
#include "host/counted.hpp"

#include <iomanip>
#include <sstream>

namespace kfast {
namespace {

using Seconds = Playback::Seconds;

std::string hexadecimal(std::uint32_t value)
{
    std::ostringstream text;
    text << std::hex << std::setw(8) << std::setfill('0') << value;
    return text.str();
}

/// Counts and hashes what was shown.
class Summary {
public:
    void add(const Frame& frame)
    {
        crc_.add(frame.pixels);
        ++count_;
    }

    void write(std::ostream& out) const
    {
        out << counted(count_, "frame") << ", hash " << hexadecimal(crc_.value()) << '\n';
    }

private:
    Crc32 crc_;
    std::size_t count_ = 0;
};

Seconds clock_at(const Timeline& timeline, int frame)
{
    return Seconds{timeline.seconds(std::int64_t{frame} * Time::ticks_per_frame)};
}

}

void play_headless(FrameSource& source, const Timeline& timeline, const std::vector<Time>& keys,
                   std::ostream& out)
{
    Playback playback{timeline, keys, Seconds{0}};
    Summary summary;
    for (int frame = 0; frame < timeline.frame_count(); ++frame) {
        playback.advance_to(clock_at(timeline, frame));
        summary.add(source.show(playback.time()));
    }
    summary.write(out);
}

void play_script(FrameSource& source, const Timeline& timeline, const std::vector<Time>& keys,
                 std::span<const PreviewKey> script, std::ostream& out)
{
    Playback playback{timeline, keys, Seconds{0}};
    Summary summary;
    int clock = 0;
    for (const PreviewKey key : script) {
        playback.press(key, clock_at(timeline, ++clock));
        if (playback.wants_to_quit())
            break;
        const Frame& frame = source.show(playback.time());
        summary.add(frame);
        out << playback.status() << "  " << hexadecimal(hash(frame)) << '\n';
    }
    summary.write(out);
}

}
