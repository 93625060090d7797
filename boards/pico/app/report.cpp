#include "boards/pico/app/report.hpp"

#include "boards/pico/app/log.hpp"
#include "core/bytes/result.hpp"
#include "firmware/version.hpp"

#include <cstdint>

namespace kfast::pico::report {
namespace {

std::string_view name_of_bus(BusKind bus) { return bus_names[static_cast<std::size_t>(bus)]; }

}

void begun(const BoardSettings& settings)
{
    write_text(log, "KFAST ");
    write_text(log, version);
    write_text(log, " pico ");
    if (leads_beam(settings.bus)) {
        write_text(log, "beam ");
        write_decimal(log, settings.beam.rate);
    } else {
        const Size size = settings.panel.size();
        write_text(log, controller_name(settings.panel.controller));
        log.write(' ');
        write_decimal(log, static_cast<std::uint32_t>(size.width));
        log.write('x');
        write_decimal(log, static_cast<std::uint32_t>(size.height));
    }
    log.write('\n');
}

void restarted(const link::Restarts& restarts)
{
    if (restarts.count == 0)
        return;
    write_text(log, "RESTARTED ");
    write_decimal(log, restarts.count);
    log.write('\n');
}

void scene_started(std::span<const std::byte> scene)
{
    if (log.is_on()) // the sum takes time
        write_scene_line(log, scene);
}

void event_passed(std::string_view name)
{
    write_text(log, "EVENT ");
    write_text(log, name);
    log.write('\n');
}

void frame_shown(FrameReport frame)
{
    write_text(log, "F ");
    write_decimal(log, static_cast<std::uint32_t>(frame.time.ticks));
    log.write(' ');
    write_decimal(log, frame.skipped);
    log.write('\n');
}

void fault(Error error)
{
    write_text(log, "ERROR ");
    write_text(log, error_text(error));
    log.write('\n');
}

void other_bus(BusKind settings, BusKind bus)
{
    write_text(log, "ERROR the settings are for a display on ");
    write_text(log, name_of_bus(settings));
    write_text(log, ", but this is the image for ");
    write_text(log, name_of_bus(bus));
    log.write('\n');
}

void mistake(SettingsMistake mistake)
{
    write_text(log, "ERROR the settings break a rule: ");
    write_text(log, settings_fault_text(mistake.fault));
    write_text(log, "; kfast config tells more\n");
}

void no_display(std::uint8_t i2c_address)
{
    constexpr std::string_view digits = "0123456789ABCDEF"; // as sellers print addresses
    write_text(log, "ERROR no display answers at 0x");
    log.write(digits[i2c_address >> 4]);
    log.write(digits[i2c_address & 15]);
    log.write('\n');
}

}
