#pragma once

#include "firmware/chip/microseconds.hpp"
#include "host/simulator/controller_model.hpp"

#include <array>
#include <chrono>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace kfast {

/// A clock that stands still except for pass().
class SimulatedClock {
public:
    Microseconds now() const { return {static_cast<std::uint32_t>(elapsed_.count())}; }
    /// The time since power-on; does not wrap.
    std::chrono::nanoseconds elapsed() const { return elapsed_; }

    void pass(Microseconds time) { elapsed_ += std::chrono::microseconds{time.count}; }

private:
    std::chrono::microseconds elapsed_{};
};

/// The wires to a controller model. As with DMA, data are read only while they are being sent, so a buffer
/// that is drawn into too early spoils the picture. The bytes take no time.
class SimulatedBus {
public:
    /// `model` and `clock` must outlive the bus.
    SimulatedBus(ControllerModel& model, const SimulatedClock& clock) : model_{model}, clock_{clock} {}

    void command(std::span<const std::byte> bytes)
    {
        expect_idle("a command");
        model_.command(clock_.elapsed(), bytes);
    }

    void parameters(std::span<const std::byte> bytes)
    {
        expect_idle("parameters");
        model_.data(clock_.elapsed(), bytes);
    }

    void start_data(std::span<const std::byte> bytes)
    {
        expect_idle("data");
        on_their_way_ = bytes;
        unit_ = 1;
    }

    void start_words(std::span<const std::byte> words)
    {
        if (words.size() % 2 != 0)
            refuse("half a word");
        start_data(words);
        unit_ = 2;
    }

    /// Every call lets half of what is left arrive.
    bool busy()
    {
        const std::size_t units = on_their_way_.size() / unit_;
        const auto now = on_their_way_.first((units - units / 2) * unit_);
        on_their_way_ = on_their_way_.subspan(now.size());
        if (unit_ == 1)
            model_.data(clock_.elapsed(), now);
        else
            send_words(now);
        return !now.empty();
    }

    /// A rule of the bus that was broken.
    const std::optional<std::string>& error() const { return error_; }

private:
    void send_words(std::span<const std::byte> words)
    {
        for (; !words.empty(); words = words.subspan(2))
            model_.data(clock_.elapsed(), std::array{words[1], words[0]});
    }

    void expect_idle(const char* what)
    {
        if (!on_their_way_.empty())
            refuse(std::string{what} + " while data are on their way");
    }

    void refuse(const std::string& what)
    {
        if (!error_)
            error_ = what;
    }

    ControllerModel& model_;
    const SimulatedClock& clock_;
    std::span<const std::byte> on_their_way_;
    std::size_t unit_ = 1; ///< bytes that arrive together
    std::optional<std::string> error_;
};

}
