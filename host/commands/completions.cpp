#include "host/commands/command.hpp"
#include "host/commands/help/bash_completion.hpp"
#include "host/commands/help/command_words.hpp"
#include "host/commands/help/fish_completion.hpp"
#include "host/commands/help/zsh_completion.hpp"
#include "host/commands/options/named_choice.hpp"
#include "host/commands/options/offered_names.hpp"

#include <array>
#include <iostream>
#include <memory>
#include <string>

namespace kfast {
namespace {

struct Shell {
    std::string_view name;
    std::string (*completion)(const CommandWords& kfast);
};

constexpr std::array shells{Shell{"bash", bash_completion}, Shell{"zsh", zsh_completion},
                            Shell{"fish", fish_completion}};

void declare_completions(CLI::App& app)
{
    const auto shell = std::make_shared<std::string>();
    offer_names(app.add_option("SHELL", *shell, names_of(shells))->required(), shells);
    app.callback([shell, &app] {
        std::cout << named(shells, "SHELL", *shell).completion(words_of_command(*app.get_parent()));
    });
}

}

const Command completions_command{"completions",
                                  "Print what a shell needs to complete commands, options and files",
                                  "kfast completions bash > ~/.local/share/bash-completion/completions/kfast",
                                  declare_completions,
                                  {},
                                  help_group};

}
