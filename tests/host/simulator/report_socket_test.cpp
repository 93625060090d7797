#include "host/simulator/report_socket.hpp"

#include "host/program/failure.hpp"
#include "tests/temporary_folder.hpp"

#include <algorithm>
#include <array>
#include <doctest/doctest.h>
#include <fstream>
#include <string>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace kfast::test {
namespace {

/// A program that talks to the board.
class Program {
public:
    explicit Program(const std::filesystem::path& path) : socket_{::socket(AF_UNIX, SOCK_SEQPACKET, 0)}
    {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::ranges::copy(path.native(), address.sun_path);
        REQUIRE(::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
    }
    ~Program() { ::close(socket_); }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    /// A report that begins with `text`.
    void say(std::string text) const
    {
        text.resize(report_bytes);
        send(text);
    }
    void send(const std::string& bytes) const
    {
        REQUIRE(::send(socket_, bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size()));
    }
    /// The first byte of the next report; -1 if there is none.
    int next() const
    {
        std::array<unsigned char, 200> bytes{};
        const ssize_t size = ::recv(socket_, bytes.data(), bytes.size(), MSG_DONTWAIT);
        return size == report_bytes ? bytes[0] : -1;
    }

private:
    int socket_;
};

std::string taken(ReportSocket& socket)
{
    const auto report = socket.take();
    return report ? reinterpret_cast<const char*>(report->bytes.data()) : "";
}

Report report_of(int first) { return {.bytes = {static_cast<std::byte>(first)}}; }

TEST_CASE("reports go both ways, whole and in order")
{
    const TemporaryFolder folder;
    ReportSocket socket{folder / "plug"};
    CHECK(taken(socket).empty());
    const Program program{folder / "plug"};
    program.say("first");
    program.say("second");
    CHECK(taken(socket) == "first");
    CHECK(taken(socket) == "second");
    CHECK(taken(socket).empty());
    socket.send(report_of(1));
    socket.send(report_of(2));
    CHECK(program.next() == 1);
    CHECK(program.next() == 2);
    CHECK(program.next() == -1);
}

TEST_CASE("what is no report is dropped")
{
    const TemporaryFolder folder;
    ReportSocket socket{folder / "plug"};
    const Program program{folder / "plug"};
    for (const std::size_t size : {1u, 63u, 65u, 1000u})
        program.send(std::string(size, 'x'));
    program.say("report");
    CHECK(taken(socket) == "report");
    CHECK(taken(socket).empty());
}

TEST_CASE("all programs hear every report, and none keeps the others from being heard")
{
    const TemporaryFolder folder;
    ReportSocket socket{folder / "plug"};
    const Program busy{folder / "plug"};
    const Program other{folder / "plug"};
    for (int i = 0; i < 20; ++i)
        busy.say("busy");
    other.say("other");
    CHECK(taken(socket) == "busy");
    CHECK(taken(socket) == "other");
    socket.send(report_of(7));
    CHECK(busy.next() == 7);
    CHECK(other.next() == 7);
}

TEST_CASE("programs come and go")
{
    const TemporaryFolder folder;
    ReportSocket socket{folder / "plug"};
    {
        const Program program{folder / "plug"};
        program.say("last words");
    }
    CHECK(taken(socket) == "last words");
    CHECK(taken(socket).empty());
    socket.send(report_of(1)); // to nobody
    const Program program{folder / "plug"};
    program.say("again");
    CHECK(taken(socket) == "again");
}

TEST_CASE("a program that fetches nothing does not stop the board")
{
    const TemporaryFolder folder;
    ReportSocket socket{folder / "plug"};
    const Program program{folder / "plug"};
    program.say("hello");
    CHECK(taken(socket) == "hello");
    for (int i = 0; i < 10'000; ++i)
        socket.send(report_of(3));
    CHECK(program.next() == 3);
}

TEST_CASE("waiting ends when something comes")
{
    const TemporaryFolder folder;
    ReportSocket socket{folder / "plug"};
    const Program program{folder / "plug"};
    CHECK(taken(socket).empty());
    program.say("now");
    socket.wait(std::chrono::hours{1});
    CHECK(taken(socket) == "now");
    socket.wait(std::chrono::microseconds{1});
    CHECK(taken(socket).empty());
}

TEST_CASE("where a board listens another one cannot")
{
    const TemporaryFolder folder;
    const auto path = folder / "plug";
    SUBCASE("it runs")
    {
        const ReportSocket first{path};
        CHECK_THROWS_WITH_AS(
            ReportSocket{path},
            (path.string() + ": a simulated board runs there already: name another socket with --socket")
                .c_str(),
            Failure);
    }
    SUBCASE("it ended without clearing up")
    {
        const int left_over = ::socket(AF_UNIX, SOCK_SEQPACKET, 0);
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::ranges::copy(path.native(), address.sun_path);
        REQUIRE(::bind(left_over, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
        ::close(left_over);
        CHECK_NOTHROW(ReportSocket{path});
    }
    SUBCASE("a file is there")
    {
        std::ofstream{path} << "a letter to somebody";
        CHECK_THROWS_AS(ReportSocket{path}, Failure);
        CHECK(std::filesystem::exists(path));
    }
    SUBCASE("the name leads nowhere")
    {
        std::filesystem::create_symlink(path, path);
        CHECK_THROWS_AS(ReportSocket{path}, Failure);
        CHECK_THROWS_AS(ReportSocket{path / "plug"}, Failure);
    }
    SUBCASE("the name is too long")
    {
        CHECK_THROWS_AS(ReportSocket{folder / std::string(120, 'x').c_str()}, Failure);
    }
}

TEST_CASE("the socket goes with the board")
{
    const TemporaryFolder folder;
    {
        const ReportSocket socket{folder / "plug"};
        CHECK(std::filesystem::exists(folder / "plug"));
    }
    CHECK(!std::filesystem::exists(folder / "plug"));
}

}
}
