#include "host/commands/text/progress.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

using Seconds = std::chrono::duration<double>;

TEST_CASE("progress is a bar, a share, a rate and the time that is left")
{
    CHECK(progress_text(0, 1000, Seconds{0}) == "[                    ]    0 %");
    CHECK(progress_text(500, 1000, Seconds{0.01}) == "[##########          ]   50 %");
    CHECK(progress_text(25'000, 100'000, Seconds{1}) == "[#####               ]   25 %  25.0 KB/s  3 s left");
    CHECK(progress_text(1, 100'000, Seconds{0.5}) ==
          "[                    ]    0 %  0.0 KB/s  833 min 20 s left");
    CHECK(progress_text(99'999, 100'000, Seconds{10}) ==
          "[################### ]   99 %  10.0 KB/s  1 s left");
    CHECK(progress_text(100'000, 100'000, Seconds{10}) == "[####################]  100 %  10.0 KB/s");
}

TEST_CASE("of steps the rate is left out")
{
    CHECK(work_text(0, 40, Seconds{3}) == "[                    ]    0 %");
    CHECK(work_text(10, 40, Seconds{1}) == "[#####               ]   25 %  3 s left");
    CHECK(work_text(40, 40, Seconds{4}) == "[####################]  100 %");
    CHECK(work_text(41, 40, Seconds{4}) == "[####################]  100 %");
}

TEST_CASE("without any progress nothing is foretold")
{
    CHECK(progress_text(0, 1000, Seconds{100}) == "[                    ]    0 %");
}

}
