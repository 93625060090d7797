#include "host/link/session.hpp"

#include <doctest/doctest.h>

#include <string>
#include <string_view>

namespace kfast::test {
namespace {

/// What a device reports, and what a person reads.
struct Row {
    Status status;
    std::uint32_t number;
    ExitStatus exit_status;
    std::string_view hint; ///< how it begins; empty: there is none
};

constexpr Row rows[]{
    {Status::no_room, 4096, ExitStatus::no_room, "there is room for 4096 bytes: "},
    {Status::too_large, 20'000, ExitStatus::no_room, "it holds 20000 bytes: "},
    {Status::block_too_small, 0, ExitStatus::no_room, "'kfast fit' tells "},
    {Status::unsupported_version, 0, ExitStatus::wrong_version, "update the firmware "},
    {Status::unknown_kind, 0, ExitStatus::wrong_version, "update the firmware "},
    {Status::timed_out, 0, ExitStatus::timed_out, "try again"},
    {Status::too_slow, 0, ExitStatus::refused, slow_scene_hint},
    {Status::bad_checksum, 0, ExitStatus::refused, "try again, with another cable"},
    {Status::no_transfer, 0, ExitStatus::refused, "if another program sends a scene "},
    {Status::no_such_slot, 8, ExitStatus::refused, "they go from 0 to 7"},
    {Status::no_such_slot, 0, ExitStatus::refused, "they go from 0 to 0"}, // no device says that
    {Status::empty_slot, 0, ExitStatus::refused, "'kfast slots' lists "},
    {Status::nothing_in_ram, 0, ExitStatus::refused, "send one with "},
    {Status::nothing_plays, 0, ExitStatus::refused, "play one with "},
    {Status::no_scene, 0, ExitStatus::refused, "'kfast upload SCENE --choose' brings one "},
    {Status::no_laser, 0, ExitStatus::refused, "a beam is dangerous if "},
    {Status::no_such_clip, 0, ExitStatus::refused, "'kfast info SCENE' lists "},
    {Status::no_such_input, 2, ExitStatus::refused, "another scene plays by now"},
    {Status::flash_failed, 0, ExitStatus::refused, ""},
    {static_cast<Status>(200), 0, ExitStatus::refused, ""}, // of a device to come
};

}

TEST_CASE("each reason of a device has an exit status, and a hint where something helps")
{
    for (const Row& row : rows) {
        CAPTURE(static_cast<int>(row.status));
        const Refusal refusal{{.status = row.status, .number = row.number, .text = {"its words"}}};
        CHECK(refusal.status() == row.status);
        CHECK(refusal.number() == row.number);
        CHECK(kfast::Failure{refusal}.status() == row.exit_status);
        const std::string said = refusal.what();
        const std::string begin = "the device says: its words" + std::string{row.hint.empty() ? "" : ": "};
        CHECK(said.starts_with(begin + std::string{row.hint}));
        CHECK((said == begin) == row.hint.empty());
    }
}

TEST_CASE("a device without words is told by the number of its reason")
{
    CHECK(std::string{Refusal{{.status = Status::flash_failed}}.what()} == "the device says: error 30");
}

}
