#pragma once

#include "host/simulator/controller_model.hpp"
#include "host/simulator/trace.hpp"

#include <functional>
#include <string_view>

namespace kfast {

/// Plays what an emulator saw into a model. Chip select counts only in traces that tell of it, and is
/// inactive at their beginning.
class TraceReplay {
public:
    /// `model` must outlive the replay.
    explicit TraceReplay(ControllerModel& model) : model_{model} {}

    /// Calls `on_note` with each note, when the model has received all that came before it. Throws Failure
    /// for the first mistake on the wires.
    void play(std::span<const TraceRecord> trace, const std::function<void(std::string_view note)>& on_note);

private:
    void play(const TraceRecord& record);
    void raise_reset(const TraceRecord& record);
    void expect_listener(const TraceRecord& record) const;

    ControllerModel& model_;
    bool is_selected_ = true;
    std::optional<std::chrono::nanoseconds> reset_began_; ///< the line is low
};

}
