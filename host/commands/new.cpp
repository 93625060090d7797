#include "host/atomic_file.hpp"
#include "host/commands/command.hpp"
#include "host/commands/starter.hpp"
#include "host/failure.hpp"

#include <filesystem>
#include <iostream>
#include <span>

namespace kfast {
namespace {

void write_starter(const std::filesystem::path& path)
{
    if (path.extension() != ".kfast")
        throw Failure{path.string() + ": the name of a scene text ends in .kfast"};
    std::error_code ignored;
    if (std::filesystem::symlink_status(path, ignored).type() != std::filesystem::file_type::not_found)
        throw Failure{path.string() + " exists already; choose another name, or remove it first"};
    write_file(path, std::as_bytes(std::span{starter_scene}));
    std::cout << path.string() << ": a scene to start from; see it with: kfast preview " << path.string()
              << '\n';
}

void declare_new(CLI::App& app)
{
    const auto path = std::make_shared<std::string>();
    app.add_option("SCENE", *path, "The scene text to write (.kfast)")->required();
    app.callback([path] { write_starter(*path); });
}

}

const Command new_command{"new", "Write a small scene with comments, to start from", "kfast new eyes.kfast",
                          declare_new};

}
