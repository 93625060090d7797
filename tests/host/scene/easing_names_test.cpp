#include "host/words/easing_names.hpp"

#include "core/features.hpp"
#include "tests/host/scene/scene_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <functional>
#include <numbers>
#include <string>

/// The easing functions of Robert Penner with their usual numbers: an overshoot of 1.70158, a period of 0.3
/// and three bounces.
namespace kfast::test {
namespace {

using std::numbers::pi;

double back(double u, double s) { return u * u * ((s + 1) * u - s); }
double elastic(double u, double period)
{
    return u == 0 ? 0 : -std::exp2(10 * (u - 1)) * std::sin((u - 1 - period / 4) * 2 * pi / period);
}
double bounce(double u) // from 1 down, 7.5625 being the square of 2.75
{
    const double at = (1 - u) * 2.75;
    if (at < 1)
        return 1 - at * at;
    if (at < 2)
        return 1 - ((at - 1.5) * (at - 1.5) + 0.75);
    if (at < 2.5)
        return 1 - ((at - 2.25) * (at - 2.25) + 0.9375);
    return 1 - ((at - 2.625) * (at - 2.625) + 0.984375);
}

struct Easing {
    std::string name;
    std::function<double(double)> in;
    std::function<double(double)> half; ///< of in-out
    double nearness;                    ///< of in and out
    double nearness_of_both;
};

const std::array easings{
    Easing{"sine", [](double u) { return 1 - std::cos(u * pi / 2); }, {}, 1e-5, 1e-5},
    Easing{"quad", [](double u) { return u * u; }, {}, 1e-4, 0.0032},
    Easing{"cubic", [](double u) { return u * u * u; }, {}, 1e-4, 0.0032},
    Easing{"quart", [](double u) { return std::pow(u, 4); }, {}, 0.0014, 0.0055},
    Easing{"quint", [](double u) { return std::pow(u, 5); }, {}, 0.004, 0.0095},
    Easing{"expo", [](double u) { return u == 0 ? 0 : std::exp2(10 * u - 10); }, {}, 0.0015, 0.012},
    Easing{"circ", [](double u) { return 1 - std::sqrt(1 - u * u); }, {}, 0.001, 0.02},
    Easing{"back", [](double u) { return back(u, 1.70158); },
           [](double u) { return back(u, 1.70158 * 1.525); }, 1e-4, 0.023},
    Easing{"elastic", [](double u) { return elastic(u, 0.3); }, [](double u) { return elastic(u, 0.45); },
           0.001, 0.001},
    Easing{"bounce", bounce, {}, 1e-4, 1e-4}};

VelocityLaw law_called(const std::string& name)
{
    const auto [scene, findings] =
        read_on_canvas("object o fill=red {\nkey 0 law=" + name + " { empty }\nkey 9 { empty }\n}");
    REQUIRE(findings == "");
    return key_at(*scene).laws.x;
}

double distance(const std::string& name, const std::function<double(double)>& exact)
{
    const VelocityLaw law = law_called(name);
    double furthest = 0;
    for (std::uint32_t time = 0; time <= Fraction::one; time += 16) {
        const double way = progress(law, {time}, &kfast_springs).raw / 65536.0;
        furthest = std::max(furthest, std::abs(way - exact(time / 65536.0)));
    }
    return furthest;
}

}

TEST_CASE("the laws of other programs' easings are as near to them as the documents say")
{
    for (const Easing& easing : easings) {
        CAPTURE(easing.name);
        const auto& half = easing.half ? easing.half : easing.in;
        CHECK(distance("ease-in-" + easing.name, easing.in) <= easing.nearness);
        CHECK(distance("ease-out-" + easing.name, [&](double u) { return 1 - easing.in(1 - u); }) <=
              easing.nearness);
        CHECK(distance("ease-in-out-" + easing.name, [&](double u) {
                  return u < 0.5 ? half(2 * u) / 2 : 1 - half(2 - 2 * u) / 2;
              }) <= easing.nearness_of_both);
    }
}

TEST_CASE("a name may be written in the ways of other programs")
{
    for (const char* const name : {"ease-in-out-quad", "easeInOutQuad", "ease_in_out_quad", "EaseInOutQuad"})
        CHECK(law_of_easing(name) == "bezier(0.484,0.042,0.516,0.958)");
    CHECK(law_of_easing("easeInOut") == "ease-in-out");
    CHECK(law_of_easing("Hold") == "hold");
    CHECK(law_of_easing("ease-in-out-quadratic").empty());
    CHECK(law_of_easing("").empty());
}

TEST_CASE("every other name is that of a law")
{
    for (const EasingName& easing : easing_names()) {
        CAPTURE(easing.name);
        if (easing.law != "bezier")
            CHECK(is_valid(law_called(std::string{easing.name})));
    }
}

}
