#include "host/commands/command.hpp"

#include "firmware/version.hpp"
#include "host/commands/command_line.hpp"
#include "host/commands/help/help_page.hpp"
#include "host/commands/help/usage_mistake.hpp"
#include "host/commands/lack_of_memory.hpp"
#include "host/program/failure.hpp"
#include "host/text/visible_output.hpp"

#include <algorithm>
#include <array>
#include <iostream>
#include <new>
#include <sstream>
#include <string_view>
#include <system_error>
#include <vector>

namespace kfast {
namespace {

constexpr std::array commands{
    &new_command,         &import_command, &check_command,      &info_command,         &preview_command,
    &render_command,      &hash_command,   &boards_command,     &panels_command,       &fit_command,
    &compile_command,     &wiring_command, &config_command,     &flash_command,        &uf2_command,
    &simulate_command,    &export_command, &panel_command,      &devices_command,      &play_command,
    &live_command,        &pause_command,  &resume_command,     &arm_command,          &disarm_command,
    &seek_command,        &speed_command,  &brightness_command, &upload_command,       &slots_command,
    &choose_command,      &erase_command,  &boot_command,       &install_udev_command, &schema_command,
    &completions_command, &man_command,    &help_command};

std::string exit_status_list()
{
    std::string list = "Exit status:";
    for (const auto& [status, meaning] : exit_meanings) {
        const std::string number = std::to_string(static_cast<int>(status));
        list += "\n  " + number + std::string(5 - number.size(), ' ') + meaning;
    }
    return list;
}

std::string usage_message(const CLI::App* kfast, const CLI::Error& error,
                          std::span<const char* const> arguments)
{
    std::string name;
    const CLI::App* command = kfast;
    for (auto chosen = kfast->get_subcommands(); !chosen.empty(); chosen = command->get_subcommands()) {
        command = chosen.front();
        name += command->get_name() + ' ';
    }
    return "kfast: " + usage_mistake(*command, error, arguments) + "\nTry 'kfast " + name + "--help'.\n";
}

void require_command(std::span<const char* const> arguments)
{
    const auto word = [&](std::size_t place) { return place < arguments.size() ? arguments[place] : ""; };
    std::array<std::string_view, commands.size()> names;
    std::ranges::transform(commands, names.begin(), &Command::name);
    require_command_among(names, word(1));
    const auto chosen = std::ranges::find(commands, std::string_view{word(1)}, &Command::name);
    if (chosen != commands.end() && !(*chosen)->subcommands.empty())
        require_command_among((*chosen)->subcommands, word(2));
}

/// Needs no memory.
int fail(const char* reason, ExitStatus status = ExitStatus::wrong_input)
{
    std::cerr << "kfast: " << reason << '\n';
    return static_cast<int>(status);
}

/// What is asked for with --help or --version. All of it is our own.
int print(const CLI::App& kfast, const CLI::Success& asked)
{
    std::ostringstream text;
    const int status = kfast.exit(asked, text, text);
    write_as_is(std::cout, text.view());
    return status;
}

int parse_and_run(CLI::App& kfast, std::span<const char* const> arguments)
{
    kfast.failure_message([arguments](const CLI::App* app, const CLI::Error& error) {
        return usage_message(app, error, arguments);
    });
    try {
        require_command(arguments);
        kfast.parse(static_cast<int>(arguments.size()), arguments.data());
    } catch (const CLI::Success& asked) {
        return print(kfast, asked);
    } catch (const CLI::ParseError& error) {
        kfast.exit(error);
        return static_cast<int>(ExitStatus::wrong_usage);
    }
    return 0;
}

int run_words(std::span<const char* const> arguments)
{
    CLI::App kfast{"Vector key-frame animation for microcontroller-driven displays.", "kfast"};
    declare_commands(kfast);
    const auto words = with_help_as_option(with_names_of_now(arguments, std::cerr));
    std::vector<const char*> present(words.size());
    std::ranges::transform(words, present.begin(), &std::string::c_str);
    return parse_and_run(kfast, present);
}

/// What the input, memory or the system is to blame for becomes a message; anything else is a bug.
int run_reported(std::span<const char* const> arguments)
{
    try {
        return run_words(arguments);
    } catch (const Failure& failure) {
        return fail(failure.what(), failure.status());
    } catch (const std::bad_alloc&) {
        return fail(lack_of_memory);
    } catch (const std::system_error& error) { // a thread that cannot begin, a folder that cannot be read
        return fail(error.what());
    }
}

}

void declare_commands(CLI::App& kfast)
{
    kfast.formatter_fn(
        [](const CLI::App* app, const std::string&, CLI::AppFormatMode) { return help_of(*app); });
    kfast.set_version_flag("-V,-v,--version", std::string("kfast ") + version);
    kfast.footer("Example:\n  kfast preview examples/first-light.kfast\n\n'kfast help COMMAND' prints its "
                 "options.\n\n" +
                 exit_status_list());
    for (const Command* command : commands) {
        CLI::App* app = kfast.add_subcommand(command->name, command->summary)->group(command->group);
        app->footer(std::string("Example:\n  ") + command->example);
        command->declare(*app);
    }
}

int run_command_line(int count, const char* const* arguments)
{
    const VisibleOutput visible_output;
    const int status = run_reported({arguments, static_cast<std::size_t>(count)});
    std::cout.flush();
    return std::cout ? status : fail("cannot write to standard output");
}

}
