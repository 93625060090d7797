#pragma once

#include "host/simulator/oled_model.hpp"

namespace kfast {

/// Solomon SSD1306: OLED, 128 x 64 pixels of one bit, 8 of a column in a byte, the upper one in the lowest
/// bit. Like most modules it makes its own voltage. Stricter than the maker: the addressing, the lines and
/// their wiring, the orientation and the voltage pump are set before the first pixel. The window is one of
/// columns and pages, and without a meaning in page addressing.
class Ssd1306Model : public OledModel {
public:
    explicit Ssd1306Model(const PanelSettings& settings);

    /// In mono1.
    Frame picture() const override;

private:
    enum class Addressing { horizontal, vertical, page };

    struct Registers {
        bool has_pump = false;
        Addressing addressing = Addressing::page;
        int page = 0; ///< in page addressing, as is the column
        int column = 0;
        bool mirrors_columns = true; ///< relative to the module as it is mounted
        bool scans_from_first = true;
        bool is_all_lit = false;
        bool inverts = false;
    };

    void forget() override
    {
        OledModel::forget();
        registers_ = {};
    }
    void begin(std::uint8_t code) override;
    void execute(std::uint8_t code, Parameters parameters) override;
    bool writes_pixels(std::uint8_t) const override { return true; }
    void take_pixels(std::uint8_t byte) override;

    void execute_place(std::uint8_t code, Parameters parameters);
    void execute_geometry(std::uint8_t code, Parameters parameters);
    void execute_display(std::uint8_t code, Parameters parameters);
    void set_addressing(std::uint8_t mode);
    void check_wiring(std::uint8_t wiring);
    void set_pump(std::uint8_t pump);
    void take_byte(int column, int page, std::uint8_t byte);
    void advance();
    OledScan scan() const;

    std::vector<bool> memory_; ///< lit pixels, row by row, as the module is mounted
    Registers registers_;
};

}
