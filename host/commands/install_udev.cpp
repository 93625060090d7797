#include "host/commands/command.hpp"
#include "host/commands/options/option_facts.hpp"
#include "host/file/atomic_file.hpp"
#include "host/program/failure.hpp"
#include "host/udev/udev.hpp"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <span>
#include <string>
#include <unistd.h>

namespace kfast {
namespace {

struct InstallUdevOptions {
    std::filesystem::path folder = "/etc/udev/rules.d";
    bool dry_run = false;
};

constexpr const char* heed_rules = "udevadm control --reload && udevadm trigger --settle "
                                   "--subsystem-match=hidraw --subsystem-match=usb";

void require_permission(const std::filesystem::path& folder)
{
    if (::access(folder.c_str(), W_OK) == 0 || (errno != EACCES && errno != EPERM))
        return;
    throw Failure{"only root may write to " + folder.string() + ":\n  " + udev_command(),
                  ExitStatus::no_permission};
}

/// udev may also be notified later, so it is no failure if that does not work.
void let_udev_heed_them()
{
    std::cout.flush();
    if (std::system(heed_rules) == 0)
        std::cout
            << "Devices that are plugged in have it now; if one may still not be opened, plug it in anew.\n";
    else
        std::cerr << "kfast: warning: udev has not been told of the rules: run this as root, or restart the "
                     "computer:\n  "
                  << heed_rules << '\n';
}

void install(const InstallUdevOptions& options)
{
    const std::filesystem::path file = options.folder / "70-kfast.rules";
    if (options.dry_run) {
        std::cout << "# would write " << file.string() << ":\n"
                  << udev_rule << "# and run: " << heed_rules << '\n';
        return;
    }
    require_permission(options.folder);
    write_file(file, std::as_bytes(std::span{udev_rule}));
    std::cout << file.string() << ": who sits at this computer, or is in the group plugdev, may use KFAST "
              << "devices and flash boards\n";
    let_udev_heed_them();
}

void declare_install_udev(CLI::App& app)
{
    const auto options = std::make_shared<InstallUdevOptions>();
    app.add_flag("--dry-run", options->dry_run, "Print what would be done, and touch nothing");
    names_folder(app.add_option("--folder", options->folder, "Where the rules go"))
        ->type_name("FOLDER")
        ->capture_default_str();
    app.callback([options] { install(*options); });
}

}

const Command install_udev_command{.name = "install-udev",
                                   .summary =
                                       "Let users open devices and flash boards, by rules of udev (as root)",
                                   .example = "sudo kfast install-udev",
                                   .declare = declare_install_udev,
                                   .group = devices_group};

}
