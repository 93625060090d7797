#include "host/commands/devices/device_options.hpp"

#include "host/commands/options/option_facts.hpp"
#include "host/commands/options/option_groups.hpp"
#include "host/commands/options/output_options.hpp"
#include "host/link/device_address.hpp"
#include "host/link/hid_pipe.hpp"

#include <algorithm>

namespace kfast {
namespace {

constexpr double shortest_timeout = 0.1;
constexpr double longest_timeout = 3600;

}

void declare_device_options(CLI::App& app, DeviceOptions& options)
{
    const OptionHeading heading{app, option_group::device};
    app.add_option("--device", options.devices,
                   "The device: a serial number, 'all', or 'sim', a simulated one; may be repeated")
        ->type_name("SERIAL")
        ->allow_extra_args(false);
    declare_talk_options(app, options);
}

void declare_talk_options(CLI::App& app, DeviceOptions& options)
{
    const OptionHeading heading{app, option_group::device};
    app.add_option("--timeout", options.timeout, "Seconds to wait for a device that is silent (default: 10)")
        ->type_name("SECONDS")
        ->check(number_within(shortest_timeout, longest_timeout));
    declare_quiet(app, options.quiet)->excludes(declare_json(app, options.json));
}

std::vector<DeviceAddress> attached_for(const std::vector<std::string>& names)
{
    if (!names.empty() && std::ranges::all_of(names, is_simulated))
        return {};
    return attached_devices();
}

Milliseconds last_patience(const DeviceOptions& options)
{
    return Milliseconds{static_cast<Milliseconds::rep>(options.timeout * 1000)};
}

OpenDevices::OpenDevices(const DeviceOptions& options)
{
    const auto addresses = chosen_addresses(options.devices, attached_for(options.devices));
    for (const DeviceAddress& address : addresses)
        devices_.push_back(open_device(address, last_patience(options)));
}

}
