#include "host/link/scene_upload.hpp"
#include "host/program/failure.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

namespace {

link::SlotContents slot(std::uint8_t number, std::string_view name)
{
    return {.slot = number, .size = name.empty() ? 0U : 100U, .name = {name}};
}

}

TEST_CASE("a scene goes where one of its name is, else into the first empty slot")
{
    const std::vector slots{slot(0, "a"), slot(1, ""), slot(2, "b"), slot(3, "")};
    CHECK(slot_for("b", slots) == 2);
    CHECK(slot_for("c", slots) == 1);
    CHECK(slot_for("", slots) == 1);
    const std::vector nameless{slot(0, "a"), slot(1, ""), link::SlotContents{.slot = 2, .size = 100}};
    CHECK(slot_for("", nameless) == 2);
    const std::vector full{slot(0, "a"), slot(1, "b")};
    CHECK(slot_for("a", full) == 0);
    try {
        slot_for("c", full);
        FAIL("there is no room");
    } catch (const Failure& failure) {
        CHECK(failure.status() == ExitStatus::no_room);
    }
}

TEST_CASE("names are kept in whole characters")
{
    CHECK(stored_name("eyes") == "eyes");
    CHECK(stored_name("123456789012345678901234") == "123456789012345678901234");
    CHECK(stored_name("1234567890123456789012345") == "123456789012345678901234");
    CHECK(stored_name("12345678901234567890123\u00e4") == "12345678901234567890123");
    CHECK(stored_name("1234567890123456789012\u00e4") == "1234567890123456789012\u00e4");
}

}
