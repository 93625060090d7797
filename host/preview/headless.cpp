#include "host/preview/headless.hpp"

#include "core/crc32.hpp"
#include "host/counted.hpp"
#include "host/text/glyph.hpp"

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

void write_events(Playback& playback, std::ostream& out)
{
    for (const EventView& event : playback.take_passed())
        out << "event " << static_cast<double>(event.time.ticks) / Time::ticks_per_frame << ' '
            << visible(event.name) << '\n';
}

}

void play_headless(FrameSource& source, const Programme& programme, std::ostream& out)
{
    const Timeline timeline{programme.frame_rate, programme.parts[programme.first].stretch, programme.speed};
    Playback playback{programme, source.pace(), Seconds{0}, 1};
    Summary summary;
    for (int frame = 0; frame < timeline.frame_count(); ++frame) {
        playback.advance_to(clock_at(timeline, frame));
        write_events(playback, out);
        summary.add(show(source, playback));
    }
    playback.advance_to(clock_at(timeline, timeline.frame_count())); // what lies behind the last frame
    write_events(playback, out);
    summary.write(out);
}

void play_script(FrameSource& source, const Programme& programme, std::span<const PreviewKey> script,
                 std::ostream& out)
{
    const Timeline timeline{programme.frame_rate, {}};
    Playback playback{programme, source.pace(), Seconds{0}};
    Summary summary;
    int clock = 0;
    for (const PreviewKey key : script) {
        playback.press(key, clock_at(timeline, ++clock));
        write_events(playback, out);
        if (playback.wants_to_quit())
            break;
        const Frame& frame = show(source, playback);
        summary.add(frame);
        out << status_of(source, playback) << "  " << hexadecimal(hash(frame)) << '\n';
    }
    summary.write(out);
}

}
