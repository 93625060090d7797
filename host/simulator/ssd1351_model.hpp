#pragma once

#include "host/simulator/oled_model.hpp"

namespace kfast {

/// Solomon SSD1351: OLED, 128 x 128 pixels in colours of 16 or 18 bits. Stricter than the maker: columns and
/// rows are set again before each writing, because the controller does not always return to their beginning;
/// remap, lines and display offset are set before the first pixel.
class Ssd1351Model : public OledModel {
public:
    explicit Ssd1351Model(const PanelSettings& settings);

    /// In rgb565.
    Frame picture() const override;

private:
    struct Registers {
        bool is_locked = false;       ///< only the lock is accepted
        bool is_inner_open = false;   ///< also the commands that the lock guards separately are accepted
        std::uint8_t remap = 0;       ///< the bits of A0h
        bool has_new_columns = false; ///< since the last writing
        bool has_new_rows = false;
        std::uint32_t bits = 0; ///< those of a pixel that is not whole yet
        int bit_count = 0;
    };

    void forget() override
    {
        OledModel::forget();
        registers_ = {};
    }
    void begin(std::uint8_t code) override;
    void execute(std::uint8_t code, Parameters parameters) override;
    bool writes_pixels(std::uint8_t code) const override { return code == 0x5C; }
    void take_pixels(std::uint8_t byte) override;

    void execute_display(std::uint8_t code, Parameters parameters);
    void start_writing();
    void set_remap(std::uint8_t remap);
    void set_lock(std::uint8_t key);
    void take_pixel(StoredColour colour);
    int pixel_bits() const;
    OledScan scan() const;

    ColourMemory memory_;
    Registers registers_;
};

}
