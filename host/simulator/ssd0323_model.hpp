#pragma once

#include "host/simulator/oled_model.hpp"

namespace kfast {

/// Solomon SSD0323: OLED, 128 x 80 pixels of 16 greys, two in a byte. Modules are wired so that the lowest
/// line of the glass is the controller's first. Stricter than the maker: remap and lines are set before the
/// first pixel.
class Ssd0323Model : public OledModel {
public:
    explicit Ssd0323Model(const PanelSettings& settings);

    /// In grey4.
    Frame picture() const override;

private:
    struct Registers {
        std::uint8_t remap = 0; ///< the bits of A0h
        int offset = 0;
    };

    void forget() override
    {
        OledModel::forget();
        registers_ = {};
    }
    void execute(std::uint8_t code, Parameters parameters) override;
    bool writes_pixels(std::uint8_t) const override { return true; }
    void take_pixels(std::uint8_t byte) override;

    void execute_geometry(std::uint8_t code, std::uint8_t value);
    void execute_display(std::uint8_t code);
    void set_remap(std::uint8_t remap);
    void take_pixel(int column, int row, int level);
    std::uint32_t level_at(int x, int y) const;
    std::optional<int> row_of(int line) const;
    int line_of(int row) const;
    int mirrored(int wire) const;

    std::vector<std::uint8_t> memory_; ///< levels 0..15, row by row, not remapped
    Registers registers_;
};

}
