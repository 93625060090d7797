#include "tests/host/config/random_settings.hpp"

#include "firmware/settings/board_rules.hpp"

#include <algorithm>
#include <vector>

namespace kfast::test {
namespace {

constexpr std::array<std::string_view, 9> names{
    "", "idle", "eyes shut", "true", "12", "say \"oh\"", "a/b\\c", "schl\u00e4ft", "a clip of 24 bytes here!",
};

/// Takes pins from those of the edge, none twice.
class Draw {
public:
    explicit Draw(std::mt19937& random) : random_{random}
    {
        for (Pin pin = 0; pin < rp2040::pin_count; ++pin)
            if (rp2040::is_on_pico_edge(pin))
                free_.push_back(pin);
    }

    int number(int low, int high) { return std::uniform_int_distribution{low, high}(random_); }
    bool chance() { return number(0, 1) == 1; }

    template <class Condition>
    Pin pin(Condition fits)
    {
        std::ranges::shuffle(free_, random_);
        const auto found = std::ranges::find_if(free_, fits);
        const Pin pin = found == free_.end() ? no_pin : *found;
        take(pin, 1);
        return pin;
    }
    Pin pin()
    {
        return pin([](Pin) { return true; });
    }
    void take(int first, int count)
    {
        std::erase_if(free_, [=](Pin pin) { return pin >= first && pin < first + count; });
    }

private:
    std::mt19937& random_;
    std::vector<Pin> free_;
};

StoredName random_name(Draw& draw)
{
    return {names[static_cast<std::size_t>(draw.number(0, names.size() - 1))]};
}

int multiple(Draw& draw, int step, int low, int high) { return step * draw.number(low / step, high / step); }

PanelSettings random_panel(Draw& draw)
{
    PanelSettings panel;
    panel.controller = static_cast<Controller>(draw.number(0, controller_names.size() - 1));
    const ControllerFacts& facts = facts_of(panel.controller);
    panel.glass = {multiple(draw, facts.granularity.width, facts.granularity.width, facts.memory.width),
                   multiple(draw, facts.granularity.height, facts.granularity.height, facts.memory.height)};
    panel.column = multiple(draw, facts.granularity.width, 0, facts.memory.width - panel.glass.width);
    panel.row = multiple(draw, facts.granularity.height, 0, facts.memory.height - panel.glass.height);
    panel.rotation = static_cast<Rotation>(facts.turns_across ? draw.number(0, 3) : 2 * draw.number(0, 1));
    panel.bgr = draw.chance();
    panel.inverted = draw.chance();
    panel.brightness = static_cast<std::uint8_t>(draw.number(0, 255));
    return panel;
}

BusKind random_bus(Draw& draw, Controller controller)
{
    for (;;) {
        const auto bus = static_cast<BusKind>(draw.number(0, 2));
        if (facts_of(controller).takes(bus))
            return bus;
    }
}

void draw_bus_pins(Draw& draw, BoardSettings& settings)
{
    Pin& clock = settings.pin(PinRole::clock);
    Pin& data = settings.pin(PinRole::data);
    if (settings.bus == BusKind::parallel_8) {
        data = static_cast<Pin>(draw.number(0, 15));
        draw.take(data, 8);
        clock = draw.pin();
        return;
    }
    const auto unit = [&](PinRole role, Pin pin) {
        return rp2040::function_name(role, settings.bus, pin).substr(0, 4);
    };
    clock = draw.pin([&](Pin pin) { return !unit(PinRole::clock, pin).empty(); });
    data = draw.pin([&](Pin pin) { return unit(PinRole::data, pin) == unit(PinRole::clock, clock); });
}

void draw_other_pins(Draw& draw, BoardSettings& settings)
{
    settings.pin(PinRole::dc) = draw.pin();
    for (const PinRole role : {PinRole::select, PinRole::reset, PinRole::backlight, PinRole::tearing})
        if (draw.chance())
            settings.pin(role) = draw.pin();
    if (draw.chance())
        settings.pin(PinRole::log) = draw.pin([](Pin pin) { return rp2040::uart_unit(pin).has_value(); });
    settings.panel.tearing_effect = settings.pin(PinRole::tearing) != no_pin && draw.chance();
}

ControlAction random_action(Draw& draw, ControlKind kind)
{
    for (;;) {
        const auto action = static_cast<ControlAction>(draw.number(0, control_action_names.size() - 1));
        if (is_for(action, kind) && action != ControlAction::arm) // which only a laser needs
            return action;
    }
}

Control random_control(Draw& draw)
{
    const ControlKind kind = draw.chance() ? ControlKind::knob : ControlKind::button;
    Control control{
        .kind = kind,
        .action = random_action(draw, kind),
        .pin = draw.pin([=](Pin pin) { return kind == ControlKind::button || rp2040::converter_input(pin); }),
        .name = {}};
    if (has_clip(control.action))
        control.name = random_name(draw);
    if (has_input(control.action))
        control.name = {"gaze"};
    return control;
}

void draw_controls(Draw& draw, BoardSettings& settings)
{
    const int max = draw.number(0, BoardSettings::max_controls);
    auto next = settings.controls.begin();
    for (int i = 0; i < max; ++i)
        if (const Control control = random_control(draw); control.pin != no_pin)
            *next++ = control;
}

std::uint8_t random_points(Draw& draw) { return static_cast<std::uint8_t>(draw.number(0, 255)); }

std::int16_t random_place(Draw& draw) { return static_cast<std::int16_t>(draw.number(field_min, field_max)); }

BeamProfile random_beam(Draw& draw, std::uint32_t max_points)
{
    BeamProfile beam;
    beam.rate = static_cast<std::uint32_t>(draw.number(1000, static_cast<int>(max_points)));
    beam.lit_step = static_cast<std::uint16_t>(draw.number(1, 65'535));
    beam.travel_step = static_cast<std::uint16_t>(draw.number(0, 65'535));
    for (std::uint8_t* points :
         {&beam.corner_dwell, &beam.lit_dwell, &beam.arrival_dwell, &beam.leave_dwell, &beam.light_delay})
        *points = random_points(draw);
    constexpr int min_points = 16; // of a picture
    const int max_refresh = std::min(255, static_cast<int>(beam.rate) / min_points);
    beam.min_refresh = static_cast<std::uint8_t>(draw.number(1, max_refresh));
    beam.resolution = static_cast<std::uint16_t>(64 << draw.number(0, 6));
    beam.brightness = static_cast<BeamBrightness>(draw.number(0, 2));
    beam.park = {random_place(draw), random_place(draw)};
    beam.is_laser = draw.chance();
    return beam;
}

void draw_beam(Draw& draw, BoardSettings& settings)
{
    constexpr int slowest = 1'000'000; // which carries 1000 points a second
    settings.bus = BusKind::dac;
    settings.bus_clock =
        static_cast<std::uint32_t>(draw.number(slowest, static_cast<int>(clock_range(BusKind::dac).max)));
    settings.beam = random_beam(draw, rp2040::max_points(settings.bus_clock));
    for (const PinRole role : {PinRole::clock, PinRole::data, PinRole::select, PinRole::ldac, PinRole::blank})
        settings.pin(role) = draw.pin();
    if (settings.beam.is_laser)
        settings.controls[0] = {ControlKind::button, ControlAction::arm, draw.pin(), {}};
}

}

BoardSettings random_settings(std::mt19937& random)
{
    Draw draw{random};
    BoardSettings settings;
    if (draw.number(0, 3) == 0) {
        draw_beam(draw, settings);
        return settings;
    }
    settings.panel = random_panel(draw);
    settings.bus = random_bus(draw, settings.panel.controller);
    const ClockRange clocks = clock_range(settings.bus);
    settings.bus_clock =
        static_cast<std::uint32_t>(draw.number(static_cast<int>(clocks.min), static_cast<int>(clocks.max)));
    settings.i2c_address = static_cast<std::uint8_t>(draw.number(0x08, 0x77));
    draw_bus_pins(draw, settings);
    draw_other_pins(draw, settings);
    settings.clip = random_name(draw);
    draw_controls(draw, settings);
    return settings;
}

}
