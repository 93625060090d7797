#include "boards/pico/app/log_buffer.hpp"

#include <doctest/doctest.h>

#include <string>
#include <string_view>

namespace kfast::pico::test {
namespace {

void write(LogBuffer& buffer, std::string_view text)
{
    for (const char letter : text)
        buffer.write(letter);
}

std::string taken(LogBuffer& buffer)
{
    std::string text;
    while (buffer.has_more())
        text += buffer.take();
    return text;
}

/// A line of so many letters with its end.
std::string line(std::size_t length, char letter = 'x') { return std::string(length - 1, letter) + '\n'; }

}

TEST_CASE("a line is told when it ends")
{
    LogBuffer buffer;
    write(buffer, "KFAST 1");
    CHECK_FALSE(buffer.has_more());
    write(buffer, "\nSCENE");
    CHECK(taken(buffer) == "KFAST 1\n");
    write(buffer, " 2\n");
    CHECK(taken(buffer) == "SCENE 2\n");
}

TEST_CASE("a line that does not fit is dropped whole, and no other")
{
    LogBuffer buffer;
    write(buffer, line(LogBuffer::room - 9, 'a'));
    write(buffer, line(10, 'b'));
    write(buffer, line(9, 'c'));
    write(buffer, line(1));
    CHECK(taken(buffer) == line(LogBuffer::room - 9, 'a') + line(9, 'c'));
    write(buffer, line(3, 'd'));
    CHECK(taken(buffer) == "dd\n");
}

TEST_CASE("a line longer than the buffer is dropped though it is taken from meanwhile")
{
    LogBuffer buffer;
    write(buffer, "first\n");
    write(buffer, std::string(LogBuffer::room, 'x'));
    CHECK(taken(buffer) == "first\n");
    write(buffer, "x\nlast\n");
    CHECK(taken(buffer) == "last\n");
}

TEST_CASE("lines go round the ring")
{
    LogBuffer buffer;
    for (int i = 0; i < 5000; ++i) {
        const std::string text = std::to_string(i) + '\n';
        write(buffer, text);
        REQUIRE(taken(buffer) == text);
    }
}

}
