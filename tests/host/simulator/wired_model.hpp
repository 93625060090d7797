#pragma once

#include "firmware/settings/controller_facts.hpp"
#include "host/simulator/controller_model.hpp"
#include "host/simulator/glass.hpp"
#include "tests/bytes.hpp"

#include <doctest/doctest.h>

#include <memory>
#include <string>
#include <vector>

namespace kfast::test {

/// The usual module of a controller with another glass.
inline PanelSettings with_glass(Controller controller, Size glass, int column = 0, int row = 0)
{
    PanelSettings settings = facts_of(controller).default_value;
    settings.glass = glass;
    settings.column = column;
    settings.row = row;
    settings.bgr = false;
    settings.inverted = false;
    return settings;
}

/// A model, and the wires to it in short.
class WiredModel {
public:
    explicit WiredModel(const PanelSettings& settings) : model{make_controller_model(settings)} {}

    /// All with D/C low.
    WiredModel& low(std::initializer_list<int> values)
    {
        model->command(time, bytes(values));
        return *this;
    }
    /// All with D/C high.
    WiredModel& high(std::initializer_list<int> values)
    {
        model->data(time, bytes(values));
        return *this;
    }
    /// A command whose parameters go with D/C high.
    WiredModel& send(int command, std::initializer_list<int> parameters = {})
    {
        low({command});
        return parameters.size() == 0 ? *this : high(parameters);
    }
    WiredModel& wait(double milliseconds)
    {
        time += std::chrono::nanoseconds{static_cast<std::int64_t>(milliseconds * 1e6)};
        return *this;
    }
    WiredModel& reset()
    {
        model->reset(time);
        return *this;
    }

    std::string error() const { return model->error().value_or("none"); }

    std::unique_ptr<ControllerModel> model;
    std::chrono::nanoseconds time{};
};

/// The pixels of a picture row by row, as numbers.
template <PixelFormat format>
std::vector<int> pixels_of(const Frame& frame)
{
    CHECK(frame.format == format);
    std::vector<int> pixels;
    for (int y = 0; y < frame.size.height; ++y)
        for (int x = 0; x < frame.size.width; ++x)
            pixels.push_back(static_cast<int>(pixel_of<format>(frame, x, y)));
    return pixels;
}

/// 1, 2, 3 …
inline std::vector<int> counted(int count)
{
    std::vector<int> numbers;
    for (int number = 1; number <= count; ++number)
        numbers.push_back(number);
    return numbers;
}

}
