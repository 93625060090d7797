#include "firmware/link/answer_queue.hpp"
#include "firmware/link/fields.hpp"
#include "firmware/link/message.hpp"
#include "firmware/link/received_drawing.hpp"

#include <doctest/doctest.h>

namespace kfast::link {

TEST_CASE("a message with a field that means nothing is none, whatever follows it")
{
    const Report whole = report_of(Playing{.is_playing = true, .is_paused = true, .home = Home::ram}, 1);
    REQUIRE(message_of<Playing>(whole));
    for (const std::size_t field : {0U, 1U, 2U}) {
        Report report = whole;
        report.payload()[field] = std::byte{0xFF};
        CHECK_FALSE(message_of<Playing>(report));
    }
}

TEST_CASE("an empty queue has no answer, and a full one gives all in their order")
{
    AnswerQueue queue;
    CHECK_FALSE(queue.next());
    for (int round = 0; round < 3; ++round) {
        for (std::uint8_t tag = 1; !queue.is_full(); ++tag)
            queue.put(report_of(AskPlaying{}, tag));
        for (std::uint8_t tag = 1; tag <= AnswerQueue::max; ++tag)
            CHECK(queue.next()->tag() == tag);
        CHECK_FALSE(queue.next());
        queue.put(report_of(AskPlaying{}, 99)); // the next round begins elsewhere
        CHECK(queue.next()->tag() == 99);
    }
}

TEST_CASE("the progress of a drawing comes back from its mark")
{
    for (const DrawingProgress& progress : {DrawingProgress{}, DrawingProgress{true, 0, 0},
                                            DrawingProgress{true, 7, 0xFFFF}, DrawingProgress{false, 3, 1}}) {
        const DrawingProgress read = DrawingProgress::of(progress.mark());
        CHECK(read.has_begun == progress.has_begun);
        CHECK(read.number == progress.number);
        CHECK(read.parts == progress.parts);
    }
    CHECK(DrawingProgress{}.mark() == 0); // that of a drawing of which nothing has come
}

}
