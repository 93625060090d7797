#pragma once

#include "firmware/settings/board_record.hpp"
#include "host/commands/flash/flash_job.hpp"
#include "host/config/config_input.hpp"
#include "tests/host/commands/pretend_flash_environment.hpp"
#include "tests/host/commands/pretend_images.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <iostream>
#include <sstream>
#include <string>

namespace kfast::test {

using State = DeskPico::State;

inline constexpr const char* small_scene =
    "kfast 1\ncanvas 60 40 frames=10\nobject dot fill=white { key 0 { rect 1 "
    "1 9 9 }; key 5 { rect 20 1 9 9 } }\n";
/// Its outlines find no room in a Pico.
inline const std::string large_scene = [] {
    std::string circles;
    for (int place = 0; place < 3600; ++place)
        circles +=
            " circle " + std::to_string(4 * (place % 60)) + ' ' + std::to_string(4 * (place / 60)) + " r=2;";
    return "kfast 1\ncanvas 240 240 frames=2\nobject dots fill=red {" + circles + " }\n";
}();

/// What is printed to standard error while it lives.
class Heard {
public:
    Heard() : before_{std::cerr.rdbuf(text_.rdbuf())} {}
    ~Heard() { std::cerr.rdbuf(before_); }
    Heard(const Heard&) = delete;
    Heard& operator=(const Heard&) = delete;

    std::string text() const { return text_.str(); }

private:
    std::ostringstream text_;
    std::streambuf* before_;
};

/// Someone who flashes boards on a desk: a scene onto an ST7789 with other pins, unless something else is
/// said.
struct Flasher {
    FlashOutcome run()
    {
        const FlashPlan plan{wish, images.folders()};
        return FlashJob{desk, plan, order, on_progress}.run();
    }
    PlayerOutcome run_and_wait()
    {
        const FlashPlan plan{wish, images.folders()};
        FlashJob job{desk, plan, order, on_progress};
        outcome = job.run();
        return job.await_player();
    }
    /// As it says; "status: text".
    std::string refusal()
    {
        try {
            run_and_wait();
        } catch (const Failure& failure) {
            return std::to_string(static_cast<int>(failure.status())) + ": " + failure.what();
        }
        return "nothing";
    }
    /// Of what can be said of a Pico that was there before: its settings and firmware.
    static void prepare(DeskPico& pico, BusKind bus, const std::string& configuration)
    {
        std::ranges::copy(pretend_image(bus), pico.flash.bytes().begin());
        const auto sector = config::settings_sector(config::chosen_settings(configuration));
        std::ranges::copy(sector, pico.flash.bytes().begin() + 0x3'F000);
    }
    DeskPico& running(const std::string& port, const std::string& serial = "E66058388341A22C")
    {
        DeskPico& pico = desk.add(port, serial);
        prepare(pico, BusKind::spi, "pico-st7789");
        pico.start();
        return pico;
    }

    PretendImages images;
    PretendFlashEnvironment desk;
    PlanWish wish{.scene = images.text("scene.kfast", small_scene),
                  .firmware = {},
                  .settings = {.config = {}, .panel = "st7789", .pins = {"dc=8"}}};
    FlashOrder order;
    FlashOutcome outcome;
    FlashProgressCallback on_progress = [](FlashPhase, std::size_t, std::size_t) {};
};

inline BoardSettings settings_of(const DeskPico& pico)
{
    return read_board_record(std::span{pico.flash.bytes()}.subspan(0x3'F000)).value();
}

inline bool holds(const DeskPico& pico, BusKind bus)
{
    const auto image = pretend_image(bus);
    return std::equal(image.begin(), image.end(), pico.flash.bytes().begin());
}

inline bool has(const std::string& text, const std::string& part)
{
    CAPTURE(text);
    return text.find(part) != text.npos;
}

}
