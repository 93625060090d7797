#include "host/link/socket_pipe.hpp"

#include "host/link/unplugged.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace kfast {
namespace {

/// How long a board may take no report, as the kernel has it for USB.
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

    void send(const link::Report& report) override
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

    std::optional<link::Report> receive(Milliseconds patience) override
    {
        if (!wait_for(POLLIN, patience))
            return std::nullopt;
        std::array<std::byte, link::report_bytes + 1> bytes{}; // one more tells what is too long
        const ssize_t count = ::recv(socket_, bytes.data(), bytes.size(), MSG_DONTWAIT);
        if (count == 0 || (count < 0 && errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR))
            throw unplugged();
        if (count != static_cast<ssize_t>(link::report_bytes))
            return std::nullopt;
        link::Report report;
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

}

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

}
