#pragma once

#include "firmware/board.hpp"
#include "firmware/controller_facts.hpp"
#include "firmware/panel/ssd0323.hpp"
#include "firmware/panel_mirror.hpp"
#include "host/simulator/simulated_bus.hpp"
#include "host/simulator/ssd0323_model.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace kfast {

/// A frame as the panel showed it.
struct ShownFrame {
    Time time;
    std::vector<std::string> events; ///< passed since the frame before
    std::uint32_t hash = 0;          ///< CRC-32 of what was sent to make it, row by row in the panel's format
    std::vector<std::uint8_t> picture; ///< grey levels 0..15, row by row, decoded from the bus
};

/// A board that exists in memory: the firmware's loop and driver run on it against a model of the controller.
/// Its clock stands still while a frame is drawn, so that no frame is ever late.
class SimulatedBoard {
public:
    /// Runs for so many frames. `scene`'s bytes must outlive the board.
    SimulatedBoard(std::span<const std::byte> scene, std::size_t frames);
    SimulatedBoard(const SimulatedBoard&) = delete;

    const std::vector<ShownFrame>& frames() const { return frames_; }
    /// What the panel shows now: grey levels, row by row.
    Ssd0323Model::Picture picture() const { return model_.picture(); }
    /// Why the scene cannot be played.
    const std::optional<Error>& error() const { return error_; }
    /// What driver or loop did wrong on the wires.
    std::optional<std::string> bus_error() const { return bus_.error() ? bus_.error() : model_.error(); }

    Ssd0323<SimulatedBus<Ssd0323Model>>& panel() { return panel_; }
    Microseconds now() const { return now_; }
    void sleep_until(Microseconds moment) { now_ = moment; }

    std::span<const std::byte> scene_bytes() const { return scene_; }
    std::span<std::byte> block() { return block_; }
    std::array<std::span<std::byte>, 2> bands() { return {bands_[0], bands_[1]}; }

    bool running() const { return frames_.size() < frames_wanted_; }
    void scene_started(const SceneView&) {}
    void event_passed(const EventView& event) { passed_.emplace_back(event.name); }
    void watch(Rect area, std::span<const std::byte> pixels) { mirror_.take(area, pixels); }
    void frame_shown(FrameReport report);
    void fault(Error error) { error_ = error; }

private:
    static constexpr int band_rows = 8;

    std::span<const std::byte> scene_;
    std::vector<std::byte> block_; ///< exactly what the scene says it needs
    std::array<std::vector<std::byte>, 2> bands_;
    Ssd0323Model model_;
    SimulatedBus<Ssd0323Model> bus_{model_};
    Ssd0323<SimulatedBus<Ssd0323Model>> panel_{bus_, facts_of(Controller::ssd0323).usual};
    Microseconds now_;
    PanelMirror<PixelFormat::grey4, Ssd0323Model::width, Ssd0323Model::height> mirror_;
    std::size_t frames_wanted_;
    std::vector<std::string> passed_;
    std::vector<ShownFrame> frames_;
    std::optional<Error> error_;
};

}
