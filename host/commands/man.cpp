#include "host/atomic_file.hpp"
#include "host/commands/command.hpp"
#include "host/commands/man_page.hpp"
#include "host/commands/output_folder.hpp"

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

void declare_man(CLI::App& app)
{
    const auto folder = std::make_shared<std::string>();
    app.add_option("FOLDER", *folder,
                   "Where to write the pages of all commands, in man1 and man5; made if need be");
    app.callback([folder, &app] {
        const auto pages = man_pages(words_of_command(*app.get_parent()), scene::vocabulary());
        if (folder->empty())
            std::cout << pages.front().text;
        else
            write_pages(pages, *folder);
    });
}

}

const Command man_command{"man",
                          "Print the manual page of kfast, or write those of all commands",
                          "kfast man ~/.local/share/man\n  kfast man | man -l -",
                          declare_man,
                          {},
                          editors_group};

}
