#include "host/commands/live/live_stream.hpp"

#include "host/commands/live/line_source.hpp"
#include "host/commands/live/metronome.hpp"
#include "host/link/live_sending.hpp"
#include "host/link/on_each.hpp"
#include "host/program/failure.hpp"
#include "host/program/interruption.hpp"

#include <atomic>
#include <deque>
#include <exception>
#include <thread>
#include <unistd.h>

namespace kfast {
namespace {

/// Values from standard input on their way to devices: a thread reads, and one for each device sends.
class LiveStream {
public:
    LiveStream(std::span<RemoteDevice> devices, std::span<const LiveInput> inputs,
               const StreamOptions& stream_options)
        : devices_{devices}, inputs_{inputs}, stream_options_{stream_options}, feeds_(devices.size())
    {
    }

    void run()
    {
        std::jthread reader{[this] { read(); }};
        on_each(devices_, [this](RemoteDevice& device, std::size_t index) { send(device, feeds_[index]); });
        reader.join();
        if (mistake_)
            std::rethrow_exception(mistake_);
    }

private:
    static constexpr Milliseconds unheeded_at_most{100};

    void read()
    {
        try {
            read_lines();
        } catch (...) {
            mistake_ = std::current_exception();
        }
        for (LiveFeed& feed : feeds_)
            feed.close();
    }

    bool has_to_end() const { return has_failed_ || was_interrupted(); }

    void read_lines()
    {
        LineSource lines{STDIN_FILENO};
        Metronome metronome{stream_options_.rate};
        while (!has_to_end() && !lines.is_over()) {
            const auto line = lines.next(unheeded_at_most);
            if (!line)
                continue;
            const LiveValues values = read_live_line(*line, lines.number(), inputs_);
            if (values.empty())
                continue;
            while (!has_to_end() && !metronome.is_due(unheeded_at_most))
                continue;
            for (LiveFeed& feed : feeds_)
                feed.put(values);
        }
    }

    void send(RemoteDevice& device, LiveFeed& feed)
    {
        Session& session = device.session();
        try {
            arm(session);
            send_live(session, feed, stream_options_.silence / 3);
            disarm(session);
        } catch (const Failure&) {
            has_failed_ = true;
            leave(session);
            throw;
        }
    }

    bool wants_watch() const { return stream_options_.afterwards != Afterwards::go_on; }

    /// So that it is done also if this computer just stops.
    void arm(Session& session) const
    {
        const auto action = stream_options_.afterwards == Afterwards::hold ? link::SilenceAction::hold
                                                                           : link::SilenceAction::start;
        if (wants_watch())
            session.order(link::Silence{static_cast<std::uint16_t>(stream_options_.silence.count()), action});
    }

    void disarm(Session& session) const
    {
        if (stream_options_.afterwards == Afterwards::hold)
            session.order(link::Pause{});
        if (stream_options_.afterwards == Afterwards::back)
            session.order(link::Play{.home = link::Home::start}, patience_to_begin);
        if (wants_watch())
            session.order(link::Silence{});
    }

    /// The same where nobody wants to wait any more.
    void leave(Session& session) const
    {
        if (stream_options_.afterwards == Afterwards::hold)
            session.take_leave(link::report_of(link::Pause{}, session.new_tag()));
        if (stream_options_.afterwards == Afterwards::back)
            session.take_leave(link::report_of(link::Play{.home = link::Home::start}, session.new_tag()));
        if (wants_watch())
            session.take_leave(link::report_of(link::Silence{}, session.new_tag()));
    }

    std::span<RemoteDevice> devices_;
    std::span<const LiveInput> inputs_;
    StreamOptions stream_options_;
    std::deque<LiveFeed> feeds_; ///< one a device
    std::atomic<bool> has_failed_ = false;
    std::exception_ptr mistake_; ///< of the reader
};

}

void stream_live(std::span<RemoteDevice> devices, std::span<const LiveInput> inputs,
                 const StreamOptions& stream_options)
{
    LiveStream{devices, inputs, stream_options}.run();
}

}
