#include "host/commands/command.hpp"
#include "host/commands/devices/device_options.hpp"
#include "host/commands/text/json_text.hpp"
#include "host/link/remote_device.hpp"
#include "host/link/scene_upload.hpp"
#include "host/link/session.hpp"
#include "host/text/characters.hpp"

#include <charconv>
#include <iostream>
#include <nlohmann/json.hpp>

namespace kfast {
namespace {

using Json = nlohmann::ordered_json;
using Slots = std::vector<link::SlotContents>;

struct SlotsOptions {
    std::vector<std::uint8_t> slots;
    std::string choice;
    DeviceOptions device;
};

Json json_of(const Slots& slots)
{
    Json list = Json::array();
    for (const link::SlotContents& slot : slots)
        if (slot.size != 0)
            list.push_back({{"slot", slot.slot},
                            {"name", slot.name.view()},
                            {"bytes", slot.size},
                            {"crc", slot.crc},
                            {"chosen", slot.is_chosen}});
    return list;
}

void print_slot(const link::SlotContents& slot)
{
    std::cout << "  " << int{slot.slot} << "  ";
    if (slot.size == 0)
        std::cout << "empty\n";
    else
        std::cout << visible(slot.name.view()) << ", " << slot.size << " bytes"
                  << (slot.is_chosen ? ", plays from the start on" : "") << '\n';
}

void print(std::span<RemoteDevice> devices, const DeviceOptions& options)
{
    if (options.quiet)
        return;
    std::vector<Slots> slots(devices.size());
    on_each(devices, [&](RemoteDevice& device, std::size_t index) { slots[index] = slots_of(device); });
    Json json = Json::array();
    for (std::size_t index = 0; index < devices.size(); ++index) {
        json.push_back({{"device", devices[index].name()}, {"slots", json_of(slots[index])}});
        if (options.json)
            continue;
        std::cout << devices[index].name() << '\n';
        std::ranges::for_each(slots[index], print_slot);
    }
    if (options.json)
        std::cout << json_text(json);
}

void list(const SlotsOptions& options)
{
    OpenDevices devices{options.device};
    print(devices.all(), options.device);
}

/// None: the built-in scene.
std::uint8_t chosen_slot(const std::string& text)
{
    if (text == "built-in")
        return link::no_slot;
    std::uint8_t slot = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, slot);
    if (error != std::errc{} || rest != end || slot == link::no_slot)
        throw CLI::ValidationError("SLOT",
                                   "'" + visible(text) + "' is no slot: write its number, or built-in");
    return slot;
}

void choose(const SlotsOptions& options)
{
    const std::uint8_t slot = chosen_slot(options.choice);
    OpenDevices devices{options.device};
    on_each(devices.all(), [&](RemoteDevice& device, std::size_t) {
        device.session().order(link::ChooseSlot{slot}, patience_with_flash);
    });
    print(devices.all(), options.device);
}

/// A device that is asked twice, because its answer was lost, finds the slot empty the second time.
void erase(Session& session, std::uint8_t slot)
{
    const bool held_a_scene = session.ask<link::SlotContents>(link::AskSlot{slot}).size != 0;
    try {
        session.order(link::EraseSlot{slot}, patience_with_flash);
    } catch (const Refusal& refusal) {
        if (refusal.status() != Status::empty_slot || !held_a_scene)
            throw;
    }
}

void erase_all(const SlotsOptions& options)
{
    OpenDevices devices{options.device};
    on_each(devices.all(), [&](RemoteDevice& device, std::size_t) {
        for (const std::uint8_t slot : options.slots)
            erase(device.session(), slot);
    });
    print(devices.all(), options.device);
}

void declare_list(CLI::App& app)
{
    const auto options = std::make_shared<SlotsOptions>();
    declare_device_options(app, options->device);
    app.callback([options] { list(*options); });
}

void declare_choose(CLI::App& app)
{
    const auto options = std::make_shared<SlotsOptions>();
    app.add_option("SLOT", options->choice, "The number of a slot, or built-in")->required();
    declare_device_options(app, options->device);
    app.callback([options] { choose(*options); });
}

void declare_erase(CLI::App& app)
{
    const auto options = std::make_shared<SlotsOptions>();
    app.add_option("SLOT", options->slots, "The numbers of slots")->required();
    declare_device_options(app, options->device);
    app.callback([options] { erase_all(*options); });
}

}

const Command slots_command{.name = "slots",
                            .summary = "List the scenes in the slots of a device",
                            .example = "kfast slots --json",
                            .declare = declare_list,
                            .group = devices_group};

const Command choose_command{.name = "choose",
                             .summary = "Say what a device plays from its next start on",
                             .example = "kfast choose 2",
                             .declare = declare_choose,
                             .group = devices_group};

const Command erase_command{.name = "erase",
                            .summary = "Empty slots of a device",
                            .example = "kfast erase 2",
                            .declare = declare_erase,
                            .group = devices_group};

}
