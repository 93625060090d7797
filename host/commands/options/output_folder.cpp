#include "host/commands/options/output_folder.hpp"

#include "host/program/failure.hpp"

namespace kfast {

void make_output_folder(const std::filesystem::path& folder)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw Failure("cannot make the folder " + folder.string() + ": " + error.message() +
                      ": choose another");
}

}
