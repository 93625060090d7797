#include "host/sound/deflection.hpp"

#include <doctest/doctest.h>
#include <limits>

using namespace kfast;

namespace {

constexpr std::int32_t max = std::numeric_limits<std::int32_t>::max();
constexpr std::int32_t min = std::numeric_limits<std::int32_t>::min();

}

TEST_CASE("x goes to the left channel, y to the right one, over all that there is")
{
    const Deflection plain;
    CHECK(plain.sample({0, 0}) == StereoSample{0, 0});
    CHECK(plain.sample({1, -2}) == StereoSample{0x1'0000, -0x2'0000});
    CHECK(plain.sample({-32768, 32767}) == StereoSample{min, 0x7FFF'0000});
}

TEST_CASE("channels are swapped, and axes inverted, without a wrap at the end")
{
    CHECK(Deflection{.is_swapped = true}.sample({1, 2}) == StereoSample{0x2'0000, 0x1'0000});
    CHECK(Deflection{.inverts_x = true}.sample({-32768, 1}) == StereoSample{max, 0x1'0000});
    CHECK(Deflection{.inverts_y = true}.sample({1, 2}) == StereoSample{0x1'0000, -0x2'0000});
    CHECK(Deflection{.is_swapped = true, .inverts_x = true}.sample({1, 2}) ==
          StereoSample{0x2'0000, -0x1'0000});
}

TEST_CASE("the gain is a factor, and what is beyond the end stays there")
{
    CHECK(Deflection{.gain = 0.5}.sample({100, -3}) == StereoSample{50 * 0x1'0000, -0x1'8000});
    CHECK(Deflection{.gain = 4}.sample({32767, -32768}) == StereoSample{max, min});
    CHECK(Deflection{.inverts_x = true, .gain = 16}.sample({32767, 0}) == StereoSample{min, 0});
}
