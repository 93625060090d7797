#pragma once

#include "firmware/settings/panel_settings.hpp"
#include "host/picture/frame.hpp"

#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace kfast {

/// What a display controller makes of the bytes on its wires, stricter than the real one: the first mistake
/// is kept as error(), and nothing is decoded after it. Which controller it is, is chosen at run time, hence
/// virtual.
///
/// `time` is counted from the moment the power came on, and never goes back.
class ControllerModel {
public:
    virtual ~ControllerModel() = default;

    /// The reset line was low and has become high. Coming up with the power counts as one at time 0.
    virtual void reset(std::chrono::nanoseconds time) = 0;
    /// Bytes that arrive with D/C low, the first at `time`.
    virtual void command(std::chrono::nanoseconds time, std::span<const std::byte> bytes) = 0;
    /// Bytes that arrive with D/C high.
    virtual void data(std::chrono::nanoseconds time, std::span<const std::byte> bytes) = 0;

    /// What is on the glass, as the controller scans it, not turned: black while it is dark. In rgb565, grey4
    /// or mono1.
    virtual Frame picture() const = 0;
    /// What was wrong first, with the position of the byte among all bytes received.
    virtual const std::optional<std::string>& error() const = 0;
};

/// The controller with the glass that `settings` describes: `rotation` and `brightness` say nothing about a
/// glass and are not looked at; `bgr` and `inverted` say how it is made.
std::unique_ptr<ControllerModel> make_controller_model(const PanelSettings& settings);

/// A picture on the glass as somebody sees it who holds the glass so that `rotation` is upright.
Frame seen_upright(const Frame& glass, Rotation rotation);

}
