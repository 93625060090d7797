#include "host/simulator/report_socket.hpp"

#include "host/program/failure.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <poll.h>
#include <string>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>
#include <utility>

namespace kfast {
namespace {

/// Anything longer is no report in any case.
constexpr std::size_t max_bytes = 2 * report_bytes;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& why)
{
    throw Failure(path.string() + ": " + why);
}

sockaddr_un address_of(const std::filesystem::path& path)
{
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (path.native().size() >= sizeof address.sun_path)
        fail(path, "is too long for the name of a socket: at most " +
                       std::to_string(sizeof address.sun_path - 1) + " bytes");
    std::ranges::copy(path.native(), address.sun_path);
    return address;
}

int new_socket(const std::filesystem::path& path)
{
    const int made = ::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0);
    if (made < 0)
        fail(path, std::strerror(errno));
    return made;
}

/// Whether a program listens there.
bool is_answered(const std::filesystem::path& path)
{
    const sockaddr_un address = address_of(path);
    const int probe = new_socket(path);
    const bool answers = ::connect(probe, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    ::close(probe);
    return answers;
}

bool is_plug(const std::filesystem::path& path)
{
    std::error_code unknown;
    return std::filesystem::is_socket(path, unknown);
}

/// Removes that of a board that ended without clearing up. If that fails, listening will report it.
void remove_left_over(const std::filesystem::path& path)
{
    std::error_code stays;
    if (is_plug(path) && !is_answered(path))
        std::filesystem::remove(path, stays);
}

int listening_socket(const std::filesystem::path& path)
{
    const sockaddr_un address = address_of(path);
    remove_left_over(path);
    const int made = new_socket(path);
    constexpr int backlog = 8;
    const mode_t previous = ::umask(S_IRWXG | S_IRWXO); // nobody else talks to it
    const bool is_bound = ::bind(made, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    const int why = errno;
    ::umask(previous);
    if (is_bound && ::listen(made, backlog) == 0)
        return made;
    ::close(made);
    if (why == EADDRINUSE && is_plug(path) && is_answered(path))
        fail(path, "a simulated board runs there already: name another socket with --socket");
    fail(path, std::string{"cannot listen there: "} + std::strerror(why));
}

/// Whether what recv() returned means a broken connection.
bool is_broken(ssize_t size) { return size < 0 && errno != EAGAIN && errno != EINTR; }

Report first_of(std::span<const std::byte> bytes)
{
    Report report;
    std::ranges::copy(bytes.first(report_bytes), report.bytes.begin());
    return report;
}

}

ReportSocket::ReportSocket(std::filesystem::path path)
    : path_{std::move(path)}, listener_{listening_socket(path_)}
{
}

ReportSocket::~ReportSocket()
{
    std::ranges::for_each(programs_, ::close);
    ::close(listener_);
    std::error_code gone_already;
    std::filesystem::remove(path_, gone_already);
}

void ReportSocket::wait(std::chrono::microseconds time)
{
    std::vector<pollfd> sources{{listener_, POLLIN, 0}};
    for (const int program : programs_)
        sources.push_back({program, POLLIN, 0});
    const timespec patience{time.count() / 1'000'000, time.count() % 1'000'000 * 1000};
    ::ppoll(sources.data(), sources.size(), &patience, nullptr);
}

std::optional<Report> ReportSocket::take()
{
    accept_all();
    for (auto program = programs_.begin(); program != programs_.end();) {
        std::array<std::byte, max_bytes> came;
        const ssize_t size = ::recv(*program, came.data(), came.size(), MSG_DONTWAIT);
        if (size == report_bytes) {
            std::rotate(program, program + 1, programs_.end()); // it is the turn of the others
            return first_of(came);
        }
        if (size == 0 || is_broken(size)) {
            ::close(*program);
            program = programs_.erase(program);
        } else if (size < 0) {
            ++program;
        }
    }
    return std::nullopt;
}

bool ReportSocket::send(const Report& report)
{
    for (const int program : programs_)
        ::send(program, report.bytes.data(), report.bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    return true;
}

void ReportSocket::accept_all()
{
    pollfd listener{listener_, POLLIN, 0};
    while (::poll(&listener, 1, 0) > 0) {
        const int program = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
        if (program < 0)
            return;
        programs_.push_back(program);
    }
}

}
