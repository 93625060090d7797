#include "host/commands/live/live_stream.hpp"
#include "host/program/failure.hpp"

#include <doctest/doctest.h>

#include <array>
#include <string_view>
#include <unistd.h>

namespace kfast::test {

namespace {

constexpr Milliseconds at_once{0};

class Pipe {
public:
    Pipe() { REQUIRE(::pipe(ends_.data()) == 0); }
    ~Pipe()
    {
        close();
        ::close(ends_[0]);
    }
    int from() const { return ends_[0]; }
    void write(std::string_view text)
    {
        CHECK(::write(ends_[1], text.data(), text.size()) == static_cast<ssize_t>(text.size()));
    }
    void close()
    {
        if (ends_[1] >= 0)
            ::close(ends_[1]);
        ends_[1] = -1;
    }

private:
    std::array<int, 2> ends_{};
};

}

TEST_CASE("lines are told as soon as they are whole")
{
    Pipe pipe;
    LineSource lines{pipe.from()};
    CHECK_FALSE(lines.next(at_once));
    pipe.write("one\ntw");
    CHECK(lines.next(at_once) == "one");
    CHECK(lines.number() == 1);
    CHECK_FALSE(lines.next(at_once));
    pipe.write("o\n\nthree");
    CHECK(lines.next(at_once) == "two");
    CHECK(lines.next(at_once) == "");
    CHECK_FALSE(lines.next(at_once));
    CHECK_FALSE(lines.is_over());
    pipe.close();
    CHECK(lines.next(at_once) == "three");
    CHECK(lines.number() == 4);
    CHECK(lines.is_over());
}

TEST_CASE("the end after a whole line is no line")
{
    Pipe pipe;
    LineSource lines{pipe.from()};
    pipe.write("one\n");
    pipe.close();
    CHECK(lines.next(at_once) == "one");
    CHECK_FALSE(lines.next(at_once));
    CHECK(lines.is_over());
}

TEST_CASE("a line without an end is refused")
{
    Pipe pipe;
    LineSource lines{pipe.from()};
    const std::string much(60'000, 'x');
    pipe.write(much);
    CHECK_THROWS_AS(
        [&] {
            for (int part = 0; part < 100; ++part) {
                lines.next(at_once);
                if (part == 50)
                    pipe.write(much);
            }
        }(),
        Failure);
}

}
