#include "host/commands/options/output_path.hpp"

#include "host/program/failure.hpp"

namespace kfast {

namespace fs = std::filesystem;

fs::path output_path(const fs::path& output, const fs::path& input, std::string_view what)
{
    std::error_code none_yet;
    if (fs::equivalent(output, input, none_yet))
        throw Failure(output.string() + ": this would overwrite the " + std::string{what} +
                      ": choose another name with -o");
    return output;
}

}
