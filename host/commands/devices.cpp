#include "host/commands/command.hpp"
#include "host/commands/devices/device_options.hpp"
#include "host/commands/devices/playing_text.hpp"
#include "host/commands/devices/restart_text.hpp"
#include "host/commands/text/json_text.hpp"
#include "host/link/device_address.hpp"
#include "host/link/hid_pipe.hpp"
#include "host/program/failure.hpp"
#include "host/text/characters.hpp"
#include "host/udev/udev.hpp"

#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

namespace kfast {
namespace {

using Json = nlohmann::ordered_json;

struct DevicesOptions {
    DeviceOptions device;
    bool udev_rule = false;
};

/// All that a device reports about itself.
struct DeviceFacts {
    std::string name;
    link::Capabilities capabilities;
    link::Names names;
    link::Playing playing;
    link::Statistics statistics;
};

DeviceFacts facts_of(RemoteDevice& device)
{
    Session& session = device.session();
    return {device.name(), device.capabilities(), session.ask<link::Names>(link::AskNames{}),
            session.ask<link::Playing>(link::AskPlaying{}),
            session.ask<link::Statistics>(link::AskStatistics{})};
}

Json json_of(const DeviceFacts& facts)
{
    const link::Capabilities& can = facts.capabilities;
    return {
        {"device", facts.name},
        {"board", facts.names.board.view()},
        {"panel",
         {{"name", facts.names.panel.view()}, {"width", can.panel.width}, {"height", can.panel.height}}},
        {"firmware", facts.names.firmware.view()},
        {"protocol", can.protocol},
        {"slots", can.slots},
        {"memory",
         {{"player", can.block_bytes},
          {"ram", can.ram_bytes},
          {"flash", can.pool_bytes},
          {"largest_for_a_slot", can.room_bytes}}},
        {"statistics",
         {{"frames", facts.statistics.frames},
          {"late", facts.statistics.late},
          {"skipped", facts.statistics.skipped},
          {"coarse", facts.statistics.coarse},
          {"link_errors", facts.statistics.link_errors}}},
        {"playing", playing_json(facts.playing)},
        {"armed", armed_json(facts.playing)},
        {"watchdog", restart_json(facts.playing.restarts)},
    };
}

void print_text(const DeviceFacts& facts)
{
    const link::Capabilities& can = facts.capabilities;
    const link::Statistics& statistics = facts.statistics;
    std::cout << facts.name << '\n'
              << "  board       " << visible(facts.names.board.view()) << ", firmware "
              << visible(facts.names.firmware.view()) << '\n'
              << "  panel       " << visible(facts.names.panel.view()) << ", " << can.panel.width << 'x'
              << can.panel.height << '\n'
              << "  room        scenes of up to " << can.ram_bytes << " bytes in RAM, " << can.room_bytes
              << " in one of " << int{can.slots} << " slots\n"
              << "  plays       " << playing_text(facts.playing) << '\n'
              << "  frames      " << statistics.frames << " shown, " << statistics.late << " of them late, "
              << (statistics.coarse == 0 ? ""
                                         : std::to_string(statistics.coarse) + " coarser for want of room, ")
              << statistics.skipped << " left out\n";
    if (facts.playing.restarts.count != 0)
        std::cout << "  restarted   " << restart_text(facts.playing.restarts) << '\n';
    if (facts.playing.restarts.is_safe_mode())
        std::cout << "  safe mode   " << safe_mode_text(facts.playing.restarts) << '\n';
}

/// The devices that are named, or else all that are attached.
std::vector<DeviceAddress> addresses_of(const DeviceOptions& options)
{
    const std::vector<std::string> all{"all"};
    const auto& names = options.devices.empty() ? all : options.devices;
    return chosen_addresses(names, attached_for(names));
}

/// A device that does not answer does not keep the others from being listed.
void list(const DevicesOptions& options)
{
    const RememberedInterruption interruption;
    std::optional<Failure> failure;
    Json json = Json::array();
    for (const DeviceAddress& address : addresses_of(options.device)) {
        try {
            RemoteDevice device = open_device(address, last_patience(options.device));
            const DeviceFacts facts = facts_of(device);
            json.push_back(json_of(facts));
            if (!options.device.json && !options.device.quiet)
                print_text(facts);
        } catch (const Interrupted&) {
            throw;
        } catch (const Failure& found) {
            failure = failure.value_or(found);
        }
    }
    if (options.device.json)
        std::cout << json_text(json);
    if (failure)
        throw Failure{*failure};
}

void run(const DevicesOptions& options)
{
    if (options.udev_rule)
        std::cout << udev_rule;
    else
        list(options);
}

void declare_devices(CLI::App& app)
{
    const auto options = std::make_shared<DevicesOptions>();
    declare_device_options(app, options->device);
    app.add_flag("--udev-rule", options->udev_rule,
                 "Print the rules by which users may open devices, which 'kfast install-udev' installs")
        ->excludes("--device")
        ->excludes("--json");
    app.callback([options] { run(*options); });
}

}

const Command devices_command{.name = "devices",
                              .summary = "List the devices that are attached, and what they play",
                              .example = "kfast devices --json",
                              .declare = declare_devices,
                              .group = devices_group};

}
