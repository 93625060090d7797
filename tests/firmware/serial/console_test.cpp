#include "firmware/serial/console.hpp"

#include "tests/firmware/serial/recorded_console.hpp"

namespace kfast::test {

static_assert(Console<RecordedConsole>);

TEST_CASE("texts are told letter by letter, with a length or up to their 0")
{
    RecordedConsole console;
    write_text(console, "one");
    write_text(console, std::string_view{"two three"}.substr(3, 4));
    CHECK(console.written == "one thr");
}

TEST_CASE("numbers are told without zeros before them, and in eight digits of base 16")
{
    RecordedConsole console;
    for (const std::uint32_t number : {0U, 9U, 10U, 4'294'967'295U}) {
        write_decimal(console, number);
        console.write(' ');
    }
    write_hex(console, 0x0012'ABCF);
    CHECK(console.written == "0 9 10 4294967295 0012abcf");
}

TEST_CASE("a scene is told by its size and checksum")
{
    RecordedConsole console;
    constexpr std::string_view digits = "123456789"; // whose CRC-32 is known everywhere
    write_scene_line(console, std::as_bytes(std::span{digits}));
    CHECK(console.written == "SCENE 9 cbf43926\n");
}

}
