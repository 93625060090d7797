#include "host/commands/live/live_stream.hpp"

#include "host/link/live_feed.hpp"
#include "host/link/remote_device.hpp"
#include "host/link/report_pipe.hpp"
#include "host/program/failure.hpp"
#include "host/program/interruption.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <deque>
#include <exception>
#include <optional>
#include <poll.h>
#include <thread>
#include <unistd.h>

namespace kfast {

namespace {

/// Says when it is time for the next one of things that come at a rate.
class Metronome {
public:
    /// Without a rate it is always time.
    explicit Metronome(const std::optional<double>& rate)
        : step_{rate ? std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>{1 / *rate})
                     : Clock::duration{0}}
    {
    }

    /// Whether it is time, for which it waits that long; then the next one is awaited. What comes too late
    /// shifts the rest only when it is very late.
    bool is_due(Milliseconds patience)
    {
        const auto now = Clock::now();
        if (now < due_) {
            std::this_thread::sleep_until(std::min(due_, now + patience));
            return false;
        }
        constexpr std::chrono::seconds very_late{1};
        due_ = (now - due_ > very_late ? now : due_) + step_;
        return true;
    }

private:
    using Clock = std::chrono::steady_clock;

    Clock::duration step_;
    Clock::time_point due_ = Clock::now();
};

constexpr std::size_t longest_line = 65536;

}

std::optional<std::string> LineSource::next(Milliseconds patience)
{
    if (auto line = buffered_line())
        return line;
    if (!has_ended_)
        read_more(patience);
    return buffered_line();
}

void LineSource::read_more(Milliseconds patience)
{
    pollfd input{descriptor_, POLLIN, 0};
    if (::poll(&input, 1, static_cast<int>(patience.count())) <= 0)
        return;
    std::array<char, 4096> bytes{};
    const ssize_t count = ::read(descriptor_, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR && errno != EAGAIN)
        throw Failure{std::string{"standard input cannot be read: "} + std::strerror(errno)};
    if (count == 0)
        has_ended_ = true;
    if (count > 0)
        buffer_.append(bytes.data(), static_cast<std::size_t>(count));
}

std::optional<std::string> LineSource::buffered_line()
{
    const std::size_t end = buffer_.find('\n');
    if (end == std::string::npos && buffer_.size() > longest_line)
        throw Failure{"line " + std::to_string(number_ + 1) + " is longer than any that means something"};
    if (end == std::string::npos && (!has_ended_ || buffer_.empty()))
        return std::nullopt;
    ++number_;
    std::string line = buffer_.substr(0, end);
    buffer_.erase(0, end == std::string::npos ? end : end + 1);
    return line;
}

namespace {

/// Sends values from standard input to devices: a thread reads, and one for each device sends.
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

    /// So that it is done even if this computer just stops.
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

    /// The same without waiting for an answer.
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
