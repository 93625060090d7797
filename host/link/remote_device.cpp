#include "host/link/remote_device.hpp"

#include "host/link/hid_pipe.hpp"
#include "host/link/report_pipe.hpp"
#include "host/program/failure.hpp"
#include "host/program/interruption.hpp"
#include "host/text/characters.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <poll.h>
#include <random>
#include <string>
#include <sys/socket.h>
#include <sys/un.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace kfast {

namespace {

/// How long a board may take no report, as the kernel allows it for USB.
constexpr Milliseconds busy_at_most{5000};

[[noreturn]] void refuse(const std::string& path, const std::string& why)
{
    throw Failure{"no simulated board listens at " + path + " (" + why + "): start one with 'kfast simulate'",
                  ExitStatus::no_device};
}

sockaddr_un address_of(const std::string& path)
{
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (path.size() >= sizeof address.sun_path)
        refuse(path, "the path is too long");
    std::ranges::copy(path, address.sun_path);
    return address;
}

class SocketPipe final : public ReportPipe {
public:
    explicit SocketPipe(int socket) : socket_{socket} {}
    ~SocketPipe() override { ::close(socket_); }

    void send(const Report& report) override
    {
        const Milliseconds begin = now();
        while (::send(socket_, report.bytes.data(), report.bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT) < 0) {
            if (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR)
                throw unplugged();
            if (now() - begin >= busy_at_most)
                throw takes_nothing();
            wait_for(POLLOUT, Milliseconds{100});
        }
    }

    std::optional<Report> receive(Milliseconds patience) override
    {
        if (!wait_for(POLLIN, patience))
            return std::nullopt;
        std::array<std::byte, report_bytes + 1> bytes{}; // one more detects what is too long
        const ssize_t count = ::recv(socket_, bytes.data(), bytes.size(), MSG_DONTWAIT);
        if (count == 0 || (count < 0 && errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR))
            throw unplugged();
        if (count != static_cast<ssize_t>(report_bytes))
            return std::nullopt;
        Report report;
        std::copy_n(bytes.begin(), report.bytes.size(), report.bytes.begin());
        return report;
    }

    Milliseconds now() const override { return steady_milliseconds(); }

private:
    bool wait_for(short what, Milliseconds patience) const
    {
        pollfd socket{socket_, what, 0};
        return ::poll(&socket, 1, static_cast<int>(patience.count())) > 0;
    }

    int socket_;
};

/// A pipe to a simulated board that listens at `path`. Throws Failure with no_device if none does.
std::unique_ptr<ReportPipe> open_socket_pipe(const std::string& path)
{
    const sockaddr_un address = address_of(path);
    const int made = ::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0);
    if (made < 0)
        refuse(path, std::strerror(errno));
    auto pipe = std::make_unique<SocketPipe>(made);
    if (::connect(made, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0)
        return pipe;
    const int why = errno;
    if (why == EACCES || why == EPERM)
        throw Failure{"you may not talk to the simulated board at " + path + ": it belongs to another user",
                      ExitStatus::no_permission};
    refuse(path, std::strerror(why));
}

/// Skips answers to somebody who left before they came.
void pass_over_old_reports(ReportPipe& pipe)
{
    constexpr int max = 64;
    for (int count = 0; count < max && pipe.receive(Milliseconds{0}); ++count)
        continue;
}

link::Capabilities hello(Session& session)
{
    const auto capabilities = session.ask<link::Capabilities>(link::Hello{});
    if (capabilities.protocol == link::protocol_version)
        return capabilities;
    const bool is_newer = capabilities.protocol > link::protocol_version;
    throw Failure{
        "its firmware speaks version " + std::to_string(capabilities.protocol) +
            " of the link, and this kfast version " + std::to_string(link::protocol_version) +
            (is_newer ? ": update kfast"
                      : ": update the firmware: hold BOOTSEL while you plug it in, and 'kfast flash' it"),
        ExitStatus::wrong_version};
}

std::string name_of(const link::Capabilities& capabilities, const std::string& otherwise)
{
    const std::string serial = visible(capabilities.serial.view());
    return serial.empty() ? otherwise : serial;
}

std::unique_ptr<ReportPipe> open_pipe(const DeviceAddress& address)
{
    return address.way == DeviceAddress::Way::usb ? open_hid_pipe(address) : open_socket_pipe(address.path);
}

std::uint8_t random_tag()
{
    std::random_device source;
    return static_cast<std::uint8_t>(1 + source() % 255);
}

}

RemoteDevice::RemoteDevice(std::unique_ptr<ReportPipe> pipe, const Session::Options& options,
                           const std::string& name)
    : pipe_{std::move(pipe)}, session_{*pipe_, options}
{
    pass_over_old_reports(*pipe_);
    capabilities_ = hello(session_);
    name_ = name_of(capabilities_, name);
}

RemoteDevice open_device(const DeviceAddress& address, Milliseconds last_patience)
{
    try {
        return {open_pipe(address), {last_patience, random_tag()}, name_of(address)};
    } catch (const Interrupted&) {
        throw;
    } catch (const Failure& failure) {
        throw Failure{visible(name_of(address)) + ": " + failure.what(), failure.status()};
    }
}

namespace {

using Failures = std::vector<std::optional<Failure>>;

/// What a thread must not end the program with; needs no memory, of which there may be none.
std::exception_ptr thrown_by(const std::function<void()>& act)
{
    try {
        act();
        return nullptr;
    } catch (...) {
        return std::current_exception();
    }
}

/// Throws std::bad_alloc, which no device is to blame for.
std::optional<Failure> failure_of(const std::exception_ptr& thrown)
{
    if (!thrown)
        return std::nullopt;
    try {
        std::rethrow_exception(thrown);
    } catch (const Failure& failure) {
        return failure;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        return Failure{error.what()};
    }
}

/// An interruption need not be reported by every device.
bool has_interruption(const Failures& failures)
{
    for (const auto& failure : failures)
        if (failure && failure->status() == ExitStatus::interrupted)
            return true;
    return false;
}

void report(const Failures& failures, std::span<const RemoteDevice> devices)
{
    if (has_interruption(failures))
        throw Interrupted{};
    std::string text;
    std::optional<ExitStatus> status;
    for (std::size_t index = 0; index < devices.size(); ++index) {
        if (!failures[index])
            continue;
        text += (text.empty() ? "" : "\nkfast: ") + devices[index].name() + ": " + failures[index]->what();
        status = status.value_or(failures[index]->status());
    }
    if (status)
        throw Failure{text, *status};
}

}

void on_each(std::span<RemoteDevice> devices, const std::function<void(RemoteDevice&, std::size_t)>& act)
{
    std::vector<std::exception_ptr> thrown(devices.size());
    {
        std::vector<std::jthread> threads;
        for (std::size_t index = 0; index < devices.size(); ++index)
            threads.emplace_back(
                [&, index] { thrown[index] = thrown_by([&] { act(devices[index], index); }); });
    }
    Failures failures(devices.size());
    std::ranges::transform(thrown, failures.begin(), failure_of);
    report(failures, devices);
}

}
