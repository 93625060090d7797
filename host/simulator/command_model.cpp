#include "host/simulator/command_model.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace kfast {

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

}
