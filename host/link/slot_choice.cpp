#include "host/link/slot_choice.hpp"

#include "host/program/failure.hpp"
#include "host/text/utf8.hpp"

#include <algorithm>

namespace kfast {

std::vector<link::SlotContents> slots_of(RemoteDevice& device)
{
    std::vector<link::SlotContents> slots;
    for (std::uint8_t slot = 0; slot < device.capabilities().slots; ++slot)
        slots.push_back(device.session().ask<link::SlotContents>(link::AskSlot{slot}));
    return slots;
}

std::uint8_t slot_for(std::string_view name, std::span<const link::SlotContents> slots)
{
    const auto is_empty = [](const link::SlotContents& slot) { return slot.size == 0; };
    const auto has_name = [&](const link::SlotContents& slot) {
        return !is_empty(slot) && slot.name.view() == name;
    };
    auto found = std::ranges::find_if(slots, has_name);
    if (found == slots.end())
        found = std::ranges::find_if(slots, is_empty);
    if (found == slots.end())
        throw Failure{
            "all slots are taken: name the one to replace with --slot, or erase one ('kfast erase')",
            ExitStatus::no_room};
    return static_cast<std::uint8_t>(found - slots.begin());
}

std::string_view stored_name(std::string_view name)
{
    constexpr std::size_t max = std::tuple_size_v<decltype(link::Name::bytes)>;
    std::size_t length = 0;
    while (length < name.size()) {
        const std::size_t next = length + code_point_at(name, length).length;
        if (next > max)
            break;
        length = next;
    }
    return name.substr(0, length);
}

}
