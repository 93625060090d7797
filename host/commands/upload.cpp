#include "host/commands/command.hpp"
#include "host/commands/devices/device_options.hpp"
#include "host/commands/devices/sending.hpp"
#include "host/commands/import/import_options.hpp"
#include "host/commands/options/option_groups.hpp"
#include "host/commands/text/json_text.hpp"
#include "host/compile/scene_file.hpp"
#include "host/link/remote_device.hpp"
#include "host/link/scene_upload.hpp"
#include "host/text/characters.hpp"

#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

namespace kfast {
namespace {

using Json = nlohmann::ordered_json;

struct UploadOptions {
    std::string file;
    std::optional<std::uint8_t> slot;
    std::optional<std::string> name;
    bool choose = false;
    bool play = false;
    DeviceOptions device;
};

std::string chosen_name(const UploadOptions& options)
{
    if (!options.name)
        return std::string{stored_name(std::filesystem::path{options.file}.stem().string())};
    if (options.name->empty())
        throw CLI::ValidationError("--name", "is empty: leave it out, or name the scene");
    if (stored_name(*options.name) != *options.name)
        throw CLI::ValidationError("--name", "'" + visible(*options.name) +
                                                 "' is too long: a device keeps 24 bytes of a name");
    return *options.name;
}

class SceneInSlots {
public:
    SceneInSlots(const UploadOptions& options, std::span<RemoteDevice> devices)
        : options_{options}, name_{chosen_name(options)}, devices_{devices}, slots_(devices.size())
    {
    }

    void send(const SceneFile& scene)
    {
        ProgressBar bar{scene.bytes.size(), devices_.size(), shown_progress(options_.device)};
        on_each(devices_, [&](RemoteDevice& device, std::size_t index) {
            const std::uint8_t slot = options_.slot ? *options_.slot : slot_for(name_, slots_of(device));
            slots_[index] = slot;
            upload_scene(device.session(), begin_in_slot(slot, name_, scene.bytes), scene.bytes,
                         bar.of_device(index));
            if (options_.choose)
                device.session().order(link::ChooseSlot{slot}, patience_with_flash);
        });
    }
    /// To be called when all have the scene.
    void play()
    {
        on_each(devices_, [&](RemoteDevice& device, std::size_t index) {
            device.session().order(link::Play{.home = link::Home::slot, .slot = slots_[index]},
                                   patience_to_begin);
        });
    }

    void print(std::size_t bytes) const
    {
        Json json = Json::array();
        for (std::size_t index = 0; index < devices_.size(); ++index)
            json.push_back({{"device", devices_[index].name()},
                            {"slot", slots_[index]},
                            {"name", name_},
                            {"bytes", bytes},
                            {"chosen", options_.choose},
                            {"plays", options_.play}});
        if (options_.device.json)
            std::cout << json_text(json);
        else if (!options_.device.quiet)
            print_text(bytes);
    }

private:
    void print_text(std::size_t bytes) const
    {
        for (std::size_t index = 0; index < devices_.size(); ++index)
            std::cout << devices_[index].name() << ": slot " << int{slots_[index]} << " holds "
                      << visible(name_) << ", " << bytes << " bytes"
                      << (options_.choose ? "; it plays from the next start on" : "")
                      << (options_.play ? "; it plays now" : "") << '\n';
    }

    const UploadOptions& options_;
    std::string name_;
    std::span<RemoteDevice> devices_;
    std::vector<std::uint8_t> slots_;
};

void upload(const UploadOptions& options)
{
    static_cast<void>(chosen_name(options)); // before anything is reported about the scene
    const SceneFile scene = load_scene(options.file);
    OpenDevices devices{options.device};
    SceneInSlots slots{options, devices.all()};
    slots.send(scene);
    if (options.play)
        slots.play();
    slots.print(scene.bytes.size());
}

void declare_upload(CLI::App& app)
{
    const OptionHeading heading{app, option_group::contents};
    const auto options = std::make_shared<UploadOptions>();
    reads_scene(app.add_option("SCENE", options->file, loaded_scene))->required();
    app.add_option("--slot", options->slot,
                   "Where it goes (default: the slot of the same name, else the first empty one)")
        ->type_name("N");
    app.add_option("--name", options->name, "What the slot is called (default: the name of the file)")
        ->type_name("NAME");
    app.add_flag("--choose", options->choose, "Play it from the next start of the device on");
    app.add_flag("--play", options->play, "Play it now");
    declare_device_options(app, options->device);
    app.callback([options] { upload(*options); });
}

}

const Command upload_command{.name = "upload",
                             .summary = "Send a scene into a slot of the device's flash, where it stays",
                             .example = "kfast upload eyes.kfast --choose --play",
                             .declare = declare_upload,
                             .group = devices_group};

}
