#include "host/simulator/controller_model.hpp"

#include "firmware/settings/controller_facts.hpp"
#include "host/program/failure.hpp"
#include "host/simulator/dcs_model.hpp"
#include "host/simulator/glass.hpp"
#include "host/simulator/ssd0323_model.hpp"
#include "host/simulator/ssd1306_model.hpp"
#include "host/simulator/ssd1351_model.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace kfast {

namespace {

std::string text_of(Size size) { return std::to_string(size.width) + 'x' + std::to_string(size.height); }

void check_glass(const PanelSettings& settings)
{
    const Size memory = facts_of(settings.controller).memory;
    const auto fits = [](int first, int count, int all) {
        return first >= 0 && count > 0 && first + count <= all;
    };
    if (!fits(settings.column, settings.glass.width, memory.width) ||
        !fits(settings.row, settings.glass.height, memory.height))
        throw Failure("a glass of " + text_of(settings.glass) + " at column " +
                      std::to_string(settings.column) + ", row " + std::to_string(settings.row) +
                      " does not lie within the memory of the controller, " + text_of(memory));
}

using MakeModel = std::unique_ptr<ControllerModel>(const PanelSettings&);

template <class Model>
std::unique_ptr<ControllerModel> make_model(const PanelSettings& settings)
{
    return std::make_unique<Model>(settings);
}

template <const DcsKind& kind>
std::unique_ptr<ControllerModel> make_dcs_model(const PanelSettings& settings)
{
    return std::make_unique<DcsModel>(settings, kind);
}

struct ModelRow {
    Controller controller;
    MakeModel* make;
};

/// In the order of Controller.
constexpr std::array<ModelRow, controller_count> models{{
    {Controller::st7789, make_dcs_model<st7789_kind>},
    {Controller::ili9341, make_dcs_model<ili9341_kind>},
    {Controller::st7735, make_dcs_model<st7735_kind>},
    {Controller::gc9a01, make_dcs_model<gc9a01_kind>},
    {Controller::ssd1306, make_model<Ssd1306Model>},
    {Controller::ssd1351, make_model<Ssd1351Model>},
    {Controller::ssd0323, make_model<Ssd0323Model>},
}};

constexpr const ModelRow& model_row(Controller controller)
{
    return models[static_cast<std::size_t>(controller)];
}

static_assert(std::ranges::all_of(models,
                                  [](const ModelRow& row) {
                                      return &row == &model_row(row.controller) && row.make != nullptr;
                                  }),
              "one row for each Controller, in its order");

}

std::unique_ptr<ControllerModel> make_controller_model(const PanelSettings& settings)
{
    check_glass(settings);
    return model_row(settings.controller).make(settings);
}

void CommandModel::reset(std::chrono::nanoseconds time)
{
    now_ = time;
    current_ = nullptr;
    is_open_ = false;
    forget_commands();
    forget();
}

void CommandModel::command(std::chrono::nanoseconds time, std::span<const std::byte> bytes)
{
    now_ = time;
    for (const std::byte byte : bytes) {
        if (!error_)
            take_command(std::to_integer<std::uint8_t>(byte));
        ++position_;
    }
}

void CommandModel::data(std::chrono::nanoseconds time, std::span<const std::byte> bytes)
{
    now_ = time;
    for (const std::byte byte : bytes) {
        if (!error_)
            take_data(std::to_integer<std::uint8_t>(byte));
        ++position_;
    }
}

void CommandModel::take_command(std::uint8_t byte)
{
    if (is_open_ && line_ == ParameterLine::low)
        return take_parameter(byte);
    if (lacks_parameters())
        return fail("command " + hex(byte) + " where " + hex(current_->code) + " lacks parameters");
    if (is_open_)
        close_command();
    if (!error_)
        open_command(byte);
}

void CommandModel::take_data(std::uint8_t byte)
{
    if (is_open_ && line_ == ParameterLine::high)
        return take_parameter(byte);
    if (is_open_)
        return fail("data where command " + hex(current_->code) + " lacks parameters");
    if (current_ == nullptr)
        return fail("data before any command");
    if (!writes_pixels(current_->code))
        return fail("more parameters than " + hex(current_->code) + " has");
    take_pixels(byte);
}

void CommandModel::open_command(std::uint8_t code)
{
    const auto form = std::ranges::find(forms_, code, &CommandForm::code);
    if (form == forms_.end())
        return fail("unknown command " + hex(code));
    if (form->max == CommandForm::not_modelled)
        return fail("command " + hex(code) + " is not modelled");
    begin(code);
    if (error_)
        return;
    current_ = &*form;
    parameters_.clear();
    is_open_ = true;
    if (form->max == 0)
        close_command();
}

void CommandModel::take_parameter(std::uint8_t byte)
{
    parameters_.push_back(byte);
    if (parameters_.size() == static_cast<std::size_t>(current_->max))
        close_command();
}

void CommandModel::close_command()
{
    is_open_ = false;
    given_.set(current_->code);
    execute(current_->code, parameters_);
}

bool CommandModel::lacks_parameters() const
{
    return is_open_ && parameters_.size() < static_cast<std::size_t>(current_->fewest);
}

std::optional<std::uint8_t> CommandModel::missing(std::span<const NeededCommand> needed) const
{
    for (const NeededCommand& command : needed)
        if (!given_[command.code] && !given_[command.or_else])
            return command.code;
    return std::nullopt;
}

void CommandModel::fail(const std::string& what)
{
    if (error_)
        return;
    const std::chrono::duration<double, std::milli> time = now_;
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3f", time.count());
    error_ = "byte " + std::to_string(position_) + " at " + text.data() + " ms: " + what;
}

std::string hex(std::uint8_t value)
{
    std::array<char, 5> text{};
    std::snprintf(text.data(), text.size(), "0x%02X", value);
    return text.data();
}

namespace {

struct Place {
    int x;
    int y;
};

/// Where the pixel (x, y) of the upright picture is on a glass of that size.
Place on_glass(Size glass, Rotation rotation, int x, int y)
{
    switch (rotation) {
    case Rotation::none:
        return {x, y};
    case Rotation::quarter:
        return {glass.width - 1 - y, x};
    case Rotation::half:
        return {glass.width - 1 - x, glass.height - 1 - y};
    case Rotation::three_quarters:
        return {y, glass.height - 1 - x};
    }
    return {x, y};
}

}

Frame seen_upright(const Frame& glass, Rotation rotation)
{
    const Size upright = lies_across(rotation) ? Size{glass.size.height, glass.size.width} : glass.size;
    Frame frame;
    with_format(*glass.format, [&]<PixelFormat format>() {
        constexpr bool is_dithered = format == PixelFormat::mono1_dithered;
        constexpr PixelFormat coding = is_dithered ? PixelFormat::mono1 : format;
        frame = painted_frame<coding>(upright, [&](int x, int y) {
            const Place place = on_glass(glass.size, rotation, x, y);
            return pixel_of<coding>(glass, place.x, place.y);
        });
    });
    frame.format = glass.format;
    return frame;
}

}
