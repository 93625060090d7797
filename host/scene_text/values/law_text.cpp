#include "host/scene_text/values/law_text.hpp"

#include "host/scene_text/values/grid.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace kfast::scene_text {
namespace {

using art::Ease;
using art::EaseKind;

struct NamedLaw {
    std::string_view name;
    std::array<double, 4> controls;
};

constexpr std::array<NamedLaw, 4> named_laws{{{"ease", {0.25, 0.1, 0.25, 1}},
                                              {"ease-in", {0.42, 0, 1, 1}},
                                              {"ease-out", {0, 0, 0.58, 1}},
                                              {"ease-in-out", {0.42, 0, 0.58, 1}}}};

using StoredControls = std::array<std::int32_t, 4>;

StoredControls stored(const std::array<double, 4>& numbers)
{
    StoredControls result{};
    std::ranges::transform(numbers, result.begin(), [](double number) { return on_grid(number, controls); });
    return result;
}

std::string law_of(const StoredControls& numbers)
{
    for (const NamedLaw& law : named_laws)
        if (stored(law.controls) == numbers)
            return std::string{law.name};
    std::string text = "bezier(";
    for (const std::int32_t& control : numbers)
        text += decimal(control, controls) + (&control == &numbers.back() ? ')' : ',');
    return text;
}

}

std::string law_of(const Ease& ease)
{
    if (ease.kind == EaseKind::hold)
        return "hold";
    if (ease.kind == EaseKind::linear)
        return "constant";
    const StoredControls numbers =
        stored({std::clamp(ease.x1, 0.0, 1.0), ease.y1, std::clamp(ease.x2, 0.0, 1.0), ease.y2});
    if (numbers[0] == numbers[1] && numbers[2] == numbers[3])
        return "constant";
    return law_of(numbers);
}

}
