#pragma once

#include "firmware/settings/panel_settings.hpp"
#include "host/picture/picture.hpp"

#include <bitset>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace kfast {

/// A model of a display controller that decodes the bytes on its wires, stricter than the real one: the first
/// mistake is kept as error(), and nothing is decoded after it. The controller is chosen at run time, hence
/// virtual.
///
/// `time` is counted from power-on, and never goes back.
class ControllerModel {
public:
    virtual ~ControllerModel() = default;

    /// The reset line was low and has become high. Power-on counts as a reset at time 0.
    virtual void reset(std::chrono::nanoseconds time) = 0;
    /// Bytes that arrive with D/C low, the first at `time`.
    virtual void command(std::chrono::nanoseconds time, std::span<const std::byte> bytes) = 0;
    /// Bytes that arrive with D/C high.
    virtual void data(std::chrono::nanoseconds time, std::span<const std::byte> bytes) = 0;

    /// What is on the glass, as the controller scans it, not rotated: black while it is dark. In rgb565,
    /// grey4 or mono1.
    virtual Frame picture() const = 0;
    /// The first mistake, with the position of the byte among all bytes received.
    virtual const std::optional<std::string>& error() const = 0;
};

/// The controller with the glass that `settings` describes: `rotation` and `brightness` say nothing about a
/// glass and are ignored; `bgr` and `inverted` say how it is made.
std::unique_ptr<ControllerModel> make_controller_model(const PanelSettings& settings);

/// A picture on the glass as it is seen if the glass is held so that `rotation` is upright.
Frame seen_upright(const Frame& glass, Rotation rotation);

/// What a controller knows of a command: how many parameters follow it.
struct CommandForm {
    /// The controller has the command, but no model says what it does to the picture: it is refused.
    static constexpr int not_modelled = -1;

    constexpr CommandForm(int command, int parameters) : CommandForm{command, parameters, parameters} {}
    constexpr CommandForm(int command, int at_least, int at_most)
        : code{static_cast<std::uint8_t>(command)}, fewest{at_least}, max{at_most}
    {
    }

    std::uint8_t code;
    int fewest;
    int max;
};

/// A command without which pixels mean nothing; some have two forms, as on and off.
struct NeededCommand {
    std::uint8_t code;
    std::uint8_t or_else = code;
};

/// The level of D/C while a command's parameters arrive.
enum class ParameterLine { low, high };

/// A controller that knows commands of one byte with parameters: takes the bytes apart, keeps the first
/// mistake with its position and time, and decodes nothing after it.
class CommandModel : public ControllerModel {
public:
    CommandModel(const CommandModel&) = delete;

    void reset(std::chrono::nanoseconds time) final;
    void command(std::chrono::nanoseconds time, std::span<const std::byte> bytes) final;
    void data(std::chrono::nanoseconds time, std::span<const std::byte> bytes) final;
    const std::optional<std::string>& error() const final { return error_; }

protected:
    using Parameters = std::span<const std::uint8_t>;

    CommandModel(std::vector<CommandForm> forms, ParameterLine line) : forms_{std::move(forms)}, line_{line}
    {
    }

    /// Sets all registers as after power-on.
    virtual void forget() = 0;
    /// A command that the controller knows has come, its parameters have not.
    virtual void begin(std::uint8_t code) = 0;
    /// `parameters` are as many as the command's form allows.
    virtual void execute(std::uint8_t code, Parameters parameters) = 0;
    /// Whether data after this command are pixels. Data before any command are none.
    virtual bool writes_pixels(std::uint8_t code) const = 0;
    virtual void take_pixels(std::uint8_t byte) = 0;

    void fail(const std::string& what);
    /// Forgets which commands were given, as a reset does.
    void forget_commands() { given_.reset(); }
    std::chrono::nanoseconds now() const { return now_; }
    /// The first that was not sent since the last reset.
    std::optional<std::uint8_t> missing(std::span<const NeededCommand> needed) const;

private:
    void take_command(std::uint8_t byte);
    void take_data(std::uint8_t byte);
    void open_command(std::uint8_t code);
    void take_parameter(std::uint8_t byte);
    void close_command();
    bool lacks_parameters() const;

    std::vector<CommandForm> forms_;
    ParameterLine line_;
    const CommandForm* current_ = nullptr; ///< the last command that came
    std::vector<std::uint8_t> parameters_; ///< those of `current_` that have come
    bool is_open_ = false;                 ///< more parameters may come
    std::bitset<256> given_;
    std::chrono::nanoseconds now_{};
    std::size_t position_ = 0;
    std::optional<std::string> error_;
};

/// "0x2A"
std::string hex(std::uint8_t value);

}
