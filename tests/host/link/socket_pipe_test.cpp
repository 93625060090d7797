#include "host/link/remote_device.hpp"
#include "tests/firmware/link/link_bench.hpp"
#include "tests/temporary_folder.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <thread>
#include <unistd.h>

/// Devices behind a socket, as simulated ones are.
namespace kfast::test {

using namespace link;

namespace {

/// A connection of a computer, as its device has it.
class Plug {
public:
    explicit Plug(int socket) : socket_{socket} {}
    ~Plug() { ::close(socket_); }
    Plug(const Plug&) = delete;
    Plug& operator=(const Plug&) = delete;

    void send(std::span<const std::byte> bytes) const
    {
        ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL); // the computer may be gone
    }
    /// Nothing when the computer is gone.
    std::optional<Report> receive() const
    {
        Report report;
        if (::recv(socket_, report.bytes.data(), report.bytes.size(), 0) <= 0)
            return std::nullopt;
        return report;
    }

private:
    int socket_;
};

/// Takes the first connection, and does with it what `serve` does.
class Listener {
public:
    explicit Listener(std::function<void(const Plug&)> serve)
    {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::ranges::copy(path(), address.sun_path);
        socket_ = ::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0);
        REQUIRE(::bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
        REQUIRE(::listen(socket_, 1) == 0);
        thread_ = std::jthread{[this, serve = std::move(serve)] {
            const Plug plug{::accept(socket_, nullptr, nullptr)};
            serve(plug);
        }};
    }
    ~Listener()
    {
        ::shutdown(socket_, SHUT_RDWR);
        thread_.join();
        ::close(socket_);
    }
    Listener(const Listener&) = delete;
    Listener& operator=(const Listener&) = delete;

    std::string path() const { return folder_ / "board.sock"; }
    RemoteDevice open() const
    {
        return open_device({DeviceAddress::Way::socket, path(), ""}, Milliseconds{2000});
    }

private:
    TemporaryFolder folder_;
    int socket_ = -1;
    std::jthread thread_;
};

/// Answers until the computer is gone, or `count` reports have come.
void answer(const Plug& plug, int count = 1'000'000)
{
    LinkBench device;
    for (; count > 0; --count) {
        const auto report = plug.receive();
        if (!report)
            return;
        device.link.take(report->bytes, device.now);
        while (const auto reply = device.link.next_report())
            plug.send(reply->bytes);
    }
}

std::pair<ExitStatus, std::string> failure_of(const std::function<void()>& act)
{
    try {
        act();
    } catch (const kfast::Failure& failure) {
        return {failure.status(), failure.what()};
    }
    return {ExitStatus::done, ""};
}

void check_no_device(const std::string& path, const std::string& why)
{
    const auto [status, says] = failure_of([&] {
        open_device({DeviceAddress::Way::socket, path, ""}, Milliseconds{100});
    });
    CHECK(status == ExitStatus::no_device);
    CHECK(says.find(why) != std::string::npos);
}

}

TEST_CASE("a device behind a socket is asked and answers")
{
    const Listener listener{[](const Plug& plug) { answer(plug); }};
    RemoteDevice device = listener.open();
    CHECK(device.name() == "E66058388341A22C");
    CHECK(device.session().ask<Names>(AskNames{}).board.view() == "pico");
}

TEST_CASE("where no device listens that is said, with the reason")
{
    const TemporaryFolder folder;
    check_no_device(folder / "none.sock", "No such file");
    check_no_device("/" + std::string(sizeof(sockaddr_un{}.sun_path) - 1, 'x'), "the path is too long");
    check_no_device("/" + std::string(sizeof(sockaddr_un{}.sun_path) - 2, 'x'), "No such file");
}

TEST_CASE("a program that may open no more files says so")
{
    rlimit before{};
    REQUIRE(::getrlimit(RLIMIT_NOFILE, &before) == 0);
    const rlimit none{0, before.rlim_max};
    REQUIRE(::setrlimit(RLIMIT_NOFILE, &none) == 0);
    const auto [status, says] = failure_of([] {
        open_device({DeviceAddress::Way::socket, "/nowhere", ""}, Milliseconds{100});
    });
    REQUIRE(::setrlimit(RLIMIT_NOFILE, &before) == 0);
    CHECK(status == ExitStatus::no_device);
    CHECK(says.find("Too many open files") != std::string::npos);
}

TEST_CASE("what has not the length of a report is skipped")
{
    const Listener listener{[](const Plug& plug) {
        plug.send(std::vector<std::byte>(report_bytes - 1));
        plug.send(std::vector<std::byte>(report_bytes + 1));
        answer(plug);
    }};
    CHECK(listener.open().name() == "E66058388341A22C");
}

TEST_CASE("a device that is unplugged is told when it is listened to, and when it is to take something")
{
    const Listener gone_at_once{[](const Plug&) {}};
    CHECK(failure_of([&] { gone_at_once.open(); }).first == ExitStatus::unplugged);
    const Listener gone_when_asked{[](const Plug& plug) { plug.receive(); }};
    CHECK(failure_of([&] { gone_when_asked.open(); }).first == ExitStatus::unplugged);
    const Listener gone_later{[](const Plug& plug) { answer(plug, 2); }};
    RemoteDevice device = gone_later.open();
    device.session().order(Pause{});
    CHECK(failure_of([&] {
              while (true)
                  device.session().post(Pause{});
          }).first == ExitStatus::unplugged);
}

TEST_CASE("a device that is busy for a while loses nothing")
{
    constexpr int many = 2'000; // more than find room on the way
    int came = 0;
    {
        const Listener listener{[&came](const Plug& plug) {
            answer(plug, 1);
            std::this_thread::sleep_for(Milliseconds{300});
            while (plug.receive())
                ++came;
        }};
        RemoteDevice device = listener.open();
        for (int report = 0; report < many; ++report)
            device.session().post(Pause{});
    }
    CHECK(came == many);
}

}
