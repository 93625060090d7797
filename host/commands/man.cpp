#include "host/commands/command.hpp"
#include "host/commands/help/man_page.hpp"
#include "host/commands/options/output_folder.hpp"
#include "host/commands/options/report_options.hpp"
#include "host/file/atomic_file.hpp"
#include "host/text/counted.hpp"

#include <filesystem>
#include <iostream>
#include <memory>
#include <span>

namespace kfast {
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
    app.add_option("FOLDER", options->folder,
                   "Where to write the pages of all commands, in man1 and man5; made if need be");
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

}
