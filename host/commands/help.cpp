#include "host/commands/command.hpp"
#include "host/commands/help/help_page.hpp"
#include "host/commands/options/offered_names.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace kfast {
namespace {

/// They last as long as `app`.
std::vector<std::string_view> names_of_commands_in(const CLI::App& app)
{
    std::vector<std::string_view> names;
    for (const CLI::App* inner :
         app.get_subcommands([](const CLI::App* any) { return !any->get_name().empty(); }))
        names.push_back(inner->get_name());
    return names;
}

/// What it does, with_help_as_option() has done before it could be called.
void declare_help(CLI::App& app)
{
    const auto words = std::make_shared<std::vector<std::string>>();
    CLI::Option* const command = app.add_option("COMMAND", *words, "As in: kfast help render");
    offer(command, names_of_commands_in(*app.get_parent()));
    app.callback([words] {}); // they are kept until the command line has been read
}

}

const Command help_command{
    "help", "Print the help of kfast, or of a command", "kfast help render", declare_help, {}, help_group};

}
