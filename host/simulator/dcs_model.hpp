#pragma once

#include "host/simulator/controller_memory.hpp"
#include "host/simulator/controller_model.hpp"
#include "host/simulator/dcs_kind.hpp"

namespace kfast {

/// A colour controller of the MIPI DCS family. Stricter than the makers: 120 ms pass between any reset and
/// sleep out, as its state before is not known; memory access and pixel format are set before
/// the first pixel; a window is set anew after the memory access.
class DcsModel : public CommandModel {
public:
    /// `kind` is that of `settings.controller`, and must outlive the model.
    DcsModel(const PanelSettings& settings, const DcsKind& kind);

    /// In rgb565.
    Frame picture() const override;

private:
    using Time = std::chrono::nanoseconds;

    struct Registers {
        bool is_awake = false;
        bool is_on = false;
        bool inverts = false;
        std::uint8_t access = 0; ///< the bits of 36h
        bool starts_at_last_column = false;
        int pixel_bits = 0; ///< on the bus
        AddressWindow window;
        bool is_writing = false; ///< the window waits for pixels
        std::uint32_t bits = 0;  ///< those of a pixel that is not whole yet
        int bit_count = 0;
    };
    /// The first times at which something is allowed.
    struct Earliest {
        Time command;
        Time sleep_in;
        Time sleep_out;
    };

    void forget() override;
    void begin(std::uint8_t code) override;
    void execute(std::uint8_t code, Parameters parameters) override;
    bool writes_pixels(std::uint8_t code) const override { return code == 0x2C || code == 0x3C; }
    void take_pixels(std::uint8_t byte) override;

    void execute_power(std::uint8_t code);
    void check_time(std::uint8_t code);
    void check_fixed_bits(std::uint8_t code, Parameters parameters);
    void wake();
    void fall_asleep();
    void set_access(std::uint8_t access);
    void set_format(std::uint8_t format);
    void select(AddressWindow::Axis axis, Parameters parameters);
    void go_on_writing();
    bool is_ready();
    void take_pixel(StoredColour colour);
    bool is_exchanged() const;
    Size addressed() const;

    PanelSettings settings_;
    const DcsKind& kind_;
    Size memory_size_;
    ColourMemory memory_;
    Registers registers_;
    Earliest earliest_;
};

}
