#include "boards/pico/report.hpp"

#include "boards/pico/log.hpp"
#include "core/crc32.hpp"
#include "core/error_text.hpp"
#include "firmware/version.hpp"

#include <cstdint>

namespace kfast::pico::report {
namespace {

std::string_view name_of_bus(BusKind bus) { return bus_names[static_cast<std::size_t>(bus)]; }

}

void begun(const PanelSettings& panel)
{
    log::write("KFAST ");
    log::write(version);
    log::write(" pico ");
    log::write(controller_name(panel.controller));
    log::write(' ');
    log::write_decimal(static_cast<std::uint32_t>(panel.size().width));
    log::write('x');
    log::write_decimal(static_cast<std::uint32_t>(panel.size().height));
    log::write('\n');
}

void scene_started(std::span<const std::byte> scene)
{
    if (!log::is_on()) // the sum takes time
        return;
    Crc32 sum;
    sum.add(scene);
    log::write("SCENE ");
    log::write_decimal(static_cast<std::uint32_t>(scene.size()));
    log::write(' ');
    log::write_hex(sum.value());
    log::write('\n');
}

void event_passed(std::string_view name)
{
    log::write("EVENT ");
    log::write(name);
    log::write('\n');
}

void frame_shown(FrameReport frame)
{
    log::write("F ");
    log::write_decimal(static_cast<std::uint32_t>(frame.time.ticks));
    log::write(' ');
    log::write_decimal(frame.skipped);
    log::write('\n');
}

void fault(Error error)
{
    log::write("ERROR ");
    log::write(error_text(error));
    log::write('\n');
}

void other_bus(BusKind settings, BusKind bus)
{
    log::write("ERROR the settings are for a display on ");
    log::write(name_of_bus(settings));
    log::write(", but this is the image for ");
    log::write(name_of_bus(bus));
    log::write('\n');
}

void mistake(SettingsMistake mistake)
{
    log::write("ERROR the settings break rule ");
    log::write_decimal(static_cast<std::uint32_t>(mistake.fault));
    log::write("; kfast config tells more\n");
}

}
