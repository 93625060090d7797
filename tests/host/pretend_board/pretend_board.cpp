#include "firmware/link/input_message.hpp"
#include "firmware/link/link.hpp"
#include "tests/firmware/link/pretend_device.hpp"
#include "tests/firmware/slots/padded_scene.hpp"
#include "tests/firmware/slots/pretend_flash.hpp"
#include "tests/firmware/slots/small_places.hpp"

#include <CLI/CLI.hpp>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <limits>
#include <poll.h>
#include <string>
#include <sys/socket.h>
#include <sys/un.h>
#include <thread>
#include <unistd.h>

/// A board behind a socket: the firmware's own end of the link, with a device that draws nothing. It writes
/// all reports that it gets into a file, a line each, and fails as it is told.
namespace kfast::test {

namespace {

struct Options {
    std::string socket;
    std::string log;
    std::string serial = "PRETEND";
    std::uint8_t protocol = link::protocol_version;
    std::size_t silent_after = std::numeric_limits<std::size_t>::max();
    std::size_t unplugged_after = std::numeric_limits<std::size_t>::max();
    std::uint32_t microseconds = 0; ///< that a report takes
    std::uint32_t restarts = 0;     ///< the word in which a board keeps them
};

/// Knows the scene that it is to play.
class Board : public PretendDevice {
public:
    explicit Board(const Options& options)
        : serial_{options.serial}, restarts_{link::restarts_in(options.restarts).value_or(link::Restarts{})}
    {
    }

    link::DeviceFacts facts() const
    {
        link::DeviceFacts facts = PretendDevice::facts();
        facts.serial = {serial_};
        facts.restarts = restarts_;
        return facts;
    }
    link::Playing playing() const
    {
        link::Playing playing = PretendDevice::playing();
        playing.restarts = restarts_;
        return playing;
    }
    Status play(const link::SceneSelection& next, const SceneView& scene)
    {
        const std::uint8_t brightness = now.brightness;
        const Status status = PretendDevice::play(next, scene);
        now.brightness = brightness;
        now.canvas = scene.canvas();
        now.frame_rate = scene.frame_rate();
        now.length = scene.length();
        now.speed = Playhead::as_authored;
        return status;
    }
    link::InputState input(std::uint8_t number) const
    {
        InputCursor cursor = SceneView::parse(selection.scene)->inputs();
        for (std::uint8_t before = 0; before < number; ++before)
            cursor.next();
        const InputView input = cursor.next();
        return {.input = number,
                .takes = link::input_kind(input.type),
                .name = {input.name},
                .min = input.min,
                .max = input.max};
    }

private:
    std::string serial_;
    link::Restarts restarts_;
};

Microseconds time_now()
{
    const auto time = std::chrono::steady_clock::now().time_since_epoch();
    return Microseconds{
        static_cast<std::uint32_t>(std::chrono::duration_cast<std::chrono::microseconds>(time).count())};
}

class Server {
public:
    explicit Server(const Options& options)
        : options_{options},
          board_{options},
          log_{options.log},
          listener_{::socket(AF_UNIX, SOCK_SEQPACKET, 0)}
    {
        board_.built_in_scene = padded_scene(2000, 1000);
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::ranges::copy(options.socket, address.sun_path);
        if (::bind(listener_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
            ::listen(listener_, 1) != 0)
            throw std::runtime_error{"cannot listen at " + options.socket};
    }

    void serve_for_ever()
    {
        link_.play_start();
        std::cout << "ready" << std::endl;
        while (true) {
            const int program = ::accept(listener_, nullptr, nullptr);
            link_.begin_session();
            serve(program);
            link_.lose_computer();
            log("gone");
        }
    }

private:
    void serve(int program)
    {
        std::array<std::byte, 2 * report_bytes> bytes{};
        while (true) {
            pollfd source{program, POLLIN, 0};
            constexpr int looks_every = 10; // milliseconds
            if (::poll(&source, 1, looks_every) > 0) {
                const ssize_t count = ::recv(program, bytes.data(), bytes.size(), 0);
                const bool left_answers_unread = count < 0 && errno == ECONNRESET;
                if (left_answers_unread) // what it sent is still to be had
                    continue;
                if (count <= 0)
                    break;
                take(std::span{bytes}.first(static_cast<std::size_t>(count)));
            }
            link_.pass(time_now());
            answer(program);
        }
        ::close(program);
    }

    void take(std::span<const std::byte> report)
    {
        if (++taken_ > options_.unplugged_after)
            std::quick_exit(0);
        std::this_thread::sleep_for(std::chrono::microseconds{options_.microseconds});
        std::string line;
        for (const std::byte byte : report) {
            std::array<char, 3> digits{};
            std::snprintf(digits.data(), digits.size(), "%02x", std::to_integer<unsigned>(byte));
            line += digits.data();
        }
        log(line);
        link_.take(report, time_now());
    }

    void answer(int program)
    {
        while (auto report = link_.next_report()) {
            if (link::message_of<link::Capabilities>(*report))
                report->payload()[0] = static_cast<std::byte>(options_.protocol);
            if (taken_ <= options_.silent_after)
                ::send(program, report->bytes.data(), report->bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        }
    }

    void log(const std::string& line) { log_ << line << std::endl; }

    const Options& options_;
    PretendFlash flash_{small_flash_bytes};
    SlotStore<PretendFlash> slots_{flash_, small_places};
    Board board_;
    link::Link<Board, PretendFlash> link_{board_, slots_};
    std::ofstream log_;
    int listener_;
    std::size_t taken_ = 0;
};

}

}

int main(int count, char** arguments)
try {
    kfast::test::Options options;
    CLI::App app{"A board behind a socket, for tests."};
    app.add_option("SOCKET", options.socket)->required();
    app.add_option("--log", options.log);
    app.add_option("--serial", options.serial);
    app.add_option("--protocol", options.protocol);
    app.add_option("--silent-after", options.silent_after);
    app.add_option("--unplugged-after", options.unplugged_after);
    app.add_option("--microseconds", options.microseconds);
    app.add_option("--restarts", options.restarts);
    CLI11_PARSE(app, count, arguments);
    kfast::test::Server{options}.serve_for_ever();
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
} catch (...) { // clang-tidy does not see that errors of CLI11 are exceptions of the standard library
    return 1;
}
