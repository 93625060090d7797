#pragma once

#include "host/simulator/controller_memory.hpp"
#include "host/simulator/controller_model.hpp"
#include "host/simulator/glass.hpp"

#include <span>

namespace kfast {

/// What the models of Solomon's OLED controllers have in common: AEh and AFh switch the display, rows are
/// scanned from a start line on, and pixels go to a window of the memory.
class OledModel : public CommandModel {
protected:
    struct OledRegisters {
        bool is_on = false;
        int lines = 0; ///< how many are scanned
        int start = 0;
        OledShow show = OledShow::memory;
        AddressWindow window{};
    };

    /// `memory` is the columns and rows that the controller has, `required` what must have been sent before
    /// the first pixel.
    OledModel(std::vector<CommandForm> forms, ParameterLine line, const PanelSettings& settings, Size memory,
              std::span<const NeededCommand> required);

    void forget() override { oled_ = {.lines = memory_size_.height}; }
    /// Refuses to sleep while the window waits for pixels.
    void begin(std::uint8_t code) override;

    /// Sets an axis of the window, where the last position is `limit` - 1.
    void select(AddressWindow::Axis axis, Parameters parameters, int limit);
    /// `last` is the number of the last line that is scanned.
    void set_lines(int last);
    /// For the models that have no display offset.
    void check_offset(int offset);
    /// Whether pixels may come: there is a window, and it is not full. Reports it if not.
    bool is_ready(bool has_window, bool is_full);
    bool is_ready() { return is_ready(oled_.window.is_given(), oled_.window.is_full()); }
    /// Whether the glass shows the inverse of what the memory has.
    bool inverts() const { return settings_.inverted != (oled_.show == OledShow::inverse); }
    /// The lines that are scanned, up from the last one or down from the first.
    OledScan scan_of(bool from_last) const;

    PanelSettings settings_;
    OledRegisters oled_;

private:
    Size memory_size_;
    std::span<const NeededCommand> needed_;
};

}
