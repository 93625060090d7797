#include "host/link/device_address.hpp"

#include "host/program/failure.hpp"
#include "host/text/characters.hpp"

#include <algorithm>

namespace kfast {

namespace {

std::string serials_of(std::span<const DeviceAddress> attached)
{
    std::string list;
    for (const DeviceAddress& device : attached)
        list += (list.empty() ? "" : ", ") + visible(name_of(device));
    return list;
}

[[noreturn]] void refuse_none()
{
    throw Failure{"no device is attached: plug one in, or try a simulated one ('kfast simulate', and then "
                  "--device sim)",
                  ExitStatus::no_device};
}

void require_one(std::span<const DeviceAddress> attached)
{
    if (attached.empty())
        refuse_none();
}

DeviceAddress only_one(std::span<const DeviceAddress> attached)
{
    require_one(attached);
    if (attached.size() > 1)
        throw Failure{"several devices are attached: choose with --device SERIAL or --device all: " +
                          serials_of(attached),
                      ExitStatus::wrong_usage};
    return attached.front();
}

constexpr std::string_view default_simulated = "sim";
constexpr std::string_view simulated_at = "sim:";

DeviceAddress simulated(std::string_view name)
{
    return {DeviceAddress::Way::socket,
            name == default_simulated ? sim_socket_path() : std::string{name.substr(simulated_at.size())},
            {}};
}

DeviceAddress with_serial(const std::string& serial, std::span<const DeviceAddress> attached)
{
    const auto found = std::ranges::find(attached, serial, &DeviceAddress::serial);
    if (found != attached.end())
        return *found;
    throw Failure{"there is no device " + in_quotes(serial) + ": " +
                      (attached.empty() ? "none is attached" : "attached: " + serials_of(attached)),
                  ExitStatus::no_device};
}

class Choice {
public:
    void add(const DeviceAddress& device)
    {
        const auto is_same = [&](const DeviceAddress& other) {
            return other.way == device.way && other.path == device.path;
        };
        if (std::ranges::none_of(chosen, is_same))
            chosen.push_back(device);
    }

    std::vector<DeviceAddress> chosen;
};

}

bool is_simulated(std::string_view name)
{
    return name == default_simulated || name.starts_with(simulated_at);
}

std::vector<DeviceAddress> chosen_addresses(std::span<const std::string> names,
                                            std::span<const DeviceAddress> attached)
{
    if (names.empty())
        return {only_one(attached)};
    Choice choice;
    for (const std::string& name : names) {
        if (name == "all") {
            require_one(attached);
            std::ranges::for_each(attached, [&](const DeviceAddress& device) { choice.add(device); });
        } else if (is_simulated(name)) {
            choice.add(simulated(name));
        } else {
            choice.add(with_serial(name, attached));
        }
    }
    return choice.chosen;
}

}
