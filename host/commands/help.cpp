#include "host/commands/command.hpp"
#include "host/commands/help/command_words.hpp"
#include "host/commands/help/help_page.hpp"
#include "host/commands/help/law_page.hpp"
#include "host/commands/help/man_page.hpp"
#include "host/commands/help/schema_lists.hpp"
#include "host/commands/help/shell_completions.hpp"
#include "host/commands/options/option_facts.hpp"
#include "host/commands/options/option_values.hpp"
#include "host/commands/options/output_options.hpp"
#include "host/file/atomic_file.hpp"
#include "host/text/number_text.hpp"

#include <array>
#include <filesystem>
#include <iostream>
#include <memory>
#include <span>
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

/// What it does for a command, with_help_as_option() has done before it could be called.
void declare_help(CLI::App& app)
{
    const auto words = std::make_shared<std::vector<std::string>>();
    CLI::Option* const command = app.add_option("COMMAND", *words, "As in: kfast help render");
    std::vector<std::string_view> offered = names_of_commands_in(*app.get_parent());
    offered.push_back("laws");
    offer(command, offered);
    app.callback([words] {
        if (*words == std::vector<std::string>{"laws"})
            std::cout << law_page(style_of_standard_output());
    });
}

}

const Command help_command{"help",
                           "Print the help of kfast, of a command, or the curves of all velocity laws",
                           "kfast help render\n  kfast help laws",
                           declare_help,
                           {},
                           help_group};

namespace {

void write_pages(const std::vector<ManPage>& pages, const std::filesystem::path& folder)
{
    make_output_folder(folder);
    for (const ManPage& page : pages) {
        const std::filesystem::path section = folder / ("man" + page.file.substr(page.file.rfind('.') + 1));
        make_output_folder(section);
        write_file(section / page.file, std::as_bytes(std::span{page.text}));
    }
}

struct ManOptions {
    std::string folder;
    bool quiet = false;
};

void print_or_write(const ManOptions& options, const std::vector<ManPage>& pages)
{
    if (options.folder.empty()) {
        std::cout << pages.front().text;
        return;
    }
    write_pages(pages, options.folder);
    report_stream(options.quiet) << options.folder << ": " << counted(pages.size(), "manual page")
                                 << " in man1 and man5\n";
}

void declare_man(CLI::App& app)
{
    const auto options = std::make_shared<ManOptions>();
    names_folder(
        app.add_option("FOLDER", options->folder,
                       "Where to write the pages of all commands, in man1 and man5; made if need be"));
    declare_quiet(app, options->quiet);
    app.callback([options, &app] {
        print_or_write(*options, man_pages(words_of_command(*app.get_parent()), scene::language_schema()));
    });
}

}

const Command man_command{"man",
                          "Print the manual page of kfast, or write those of all commands",
                          "kfast man ~/.local/share/man\n  kfast man | man -l -",
                          declare_man,
                          {},
                          help_group};

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

namespace {

struct SchemaOptions {
    bool json = false;
    bool markdown = false;
};

void print_schema(const SchemaOptions& options)
{
    const scene::LanguageSchema words = scene::language_schema();
    if (options.json)
        std::cout << schema_json(words);
    else if (options.markdown)
        std::cout << schema_markdown(words);
    else
        std::cout << schema_kdl(words);
}

void declare_schema(CLI::App& app)
{
    const auto options = std::make_shared<SchemaOptions>();
    CLI::Option* const json = declare_json(app, options->json);
    app.add_flag("--markdown", options->markdown, "The tables of docs/scene-language.md")->excludes(json);
    app.callback([options] { print_schema(*options); });
}

}

const Command schema_command{"schema",
                             "Print what scenes may be written with: a KDL schema",
                             "kfast schema > kfast-scene.kdl",
                             declare_schema,
                             {},
                             help_group};

}
