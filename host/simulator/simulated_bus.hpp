#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace kfast {

/// The wires to a controller model. As with DMA, data are read only while they are on their way, so a buffer
/// that is drawn into too early spoils the picture.
template <class Model>
class SimulatedBus {
public:
    /// `model` must outlive the bus.
    explicit SimulatedBus(Model& model) : model_{model} {}

    void command(std::span<const std::byte> bytes)
    {
        expect_idle("a command");
        model_.command(bytes);
    }

    void parameters(std::span<const std::byte> bytes)
    {
        expect_idle("parameters");
        model_.data(bytes);
    }

    void start_data(std::span<const std::byte> bytes)
    {
        expect_idle("data");
        on_their_way_ = bytes;
    }

    /// Every question lets half of what is left arrive.
    bool busy()
    {
        const std::size_t now = on_their_way_.size() - on_their_way_.size() / 2;
        model_.data(on_their_way_.first(now));
        on_their_way_ = on_their_way_.subspan(now);
        return now != 0;
    }

    /// A rule of the bus that was broken.
    const std::optional<std::string>& error() const { return error_; }

private:
    void expect_idle(const char* what)
    {
        if (!on_their_way_.empty() && !error_)
            error_ = std::string{what} + " while data are on their way";
    }

    Model& model_;
    std::span<const std::byte> on_their_way_;
    std::optional<std::string> error_;
};

}
