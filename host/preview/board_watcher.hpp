#pragma once

#include "host/preview/window/picture_window.hpp"
#include "host/simulator/onlooker.hpp"

#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>

namespace kfast {

/// Shows a simulated board in a window, prints what it does line by line, or both.
class BoardWatcher : public Onlooker {
public:
    /// Without a window nobody can close it. To `out`, if there is one, it writes the frames, "frame 12.5
    /// 1a2b3c4d" (at frame 12.5, CRC-32 of the pixels), the events, "event step", and "nothing plays: " with
    /// its reason. The board is also switched off when `is_over` returns true.
    BoardWatcher(std::unique_ptr<PictureWindow> window, std::ostream* out, std::function<bool()> is_over);

    void see(const Frame& picture, Time moment, const link::Playing& playing) override;
    void hear(const EventView& event) override;
    void see_nothing(const Frame& picture, std::string_view why) override;
    bool has_seen_enough() override;

    /// The frame that was seen last; empty if nothing was.
    const Frame& last() const { return last_; }

private:
    void keep(const Frame& picture, const std::string& status);
    void draw();

    std::unique_ptr<PictureWindow> window_;
    std::ostream* out_;
    std::function<bool()> is_over_;
    Frame last_;
    std::string status_;
    bool is_closed_ = false;
};

}
