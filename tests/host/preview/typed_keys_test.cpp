#include "host/preview/terminal/borrowed_terminal.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("return is enter, however the terminal sends it")
{
    CHECK(typed_keys("\r\n") == std::vector{PreviewKey::edit, PreviewKey::edit});
}

TEST_CASE("letters and what a terminal sends for other keys are the keys of a preview")
{
    CHECK(typed_keys("nq ") == std::vector{PreviewKey::next_key, PreviewKey::quit, PreviewKey::play_pause});
    CHECK(typed_keys("\x1b[A\x1b[Dv\x1bOC") == std::vector{PreviewKey::faster, PreviewKey::previous_frame,
                                                           PreviewKey::reverse, PreviewKey::next_frame});
}

TEST_CASE("tab goes on and with shift back")
{
    CHECK(typed_keys("\t\x1b[Z") == std::vector{PreviewKey::next_item, PreviewKey::previous_item});
}

TEST_CASE("an escape alone is a key, other keys are passed over")
{
    CHECK(typed_keys("\x1b") == std::vector{PreviewKey::leave});
    CHECK(typed_keys("\x1b\x1b") == std::vector{PreviewKey::leave, PreviewKey::leave});
    CHECK(typed_keys("\x1b\x1b[A") == std::vector{PreviewKey::faster}); // with Alt
    CHECK(typed_keys("\x1b\x1bOA") == std::vector{PreviewKey::faster});
    CHECK(typed_keys("7\x1b[5~c").size() == 1);
    CHECK(typed_keys("").empty());
}

}
