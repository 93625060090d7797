#include "host/commands/options/output_options.hpp"

#include "host/commands/options/option_facts.hpp"
#include "host/commands/options/option_groups.hpp"
#include "host/commands/text/quantity_text.hpp"
#include "host/program/failure.hpp"
#include "host/text/number_text.hpp"

#include <cmath>
#include <iostream>
#include <system_error>

namespace kfast {

CLI::Option* declare_output(CLI::App& app, std::string& output, const std::string& help,
                            StandardOutput by_dash)
{
    const OptionHeading heading{app, option_group::output};
    const auto mistake = [by_dash](const std::string& name) -> std::string {
        if (name.empty())
            return "the name is empty: say where to write";
        if (name == "-" && by_dash == StandardOutput::is_refused)
            return "standard output is not written to: say where to write";
        return {};
    };
    return writes_file(app.add_option("-o,--output", output, help))
        ->type_name("OUT")
        ->check(CLI::Validator{mistake, ""});
}

namespace fs = std::filesystem;

fs::path output_path(const fs::path& output, const fs::path& input, std::string_view what)
{
    std::error_code none_yet;
    if (fs::equivalent(output, input, none_yet))
        throw Failure(output.string() + ": this would overwrite the " + std::string{what} +
                      ": choose another name with -o");
    return output;
}

void make_output_folder(const std::filesystem::path& folder)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw Failure("cannot make the folder " + folder.string() + ": " + error.message() +
                      ": choose another");
}

CLI::Option* declare_json(CLI::App& app, bool& json)
{
    const OptionHeading heading{app, option_group::report};
    return app.add_flag("--json", json, "Print JSON, for programs");
}

CLI::Option* declare_quiet(CLI::App& app, bool& quiet)
{
    const OptionHeading heading{app, option_group::report};
    return app.add_flag("-q,--quiet", quiet, "Print nothing but errors");
}

std::ostream& report_stream(bool quiet)
{
    static std::ostream nowhere{nullptr};
    return quiet ? nowhere : std::cout;
}

std::string file_size_text(std::uintmax_t bytes)
{
    constexpr std::uintmax_t kilo = 1000;
    if (bytes < kilo)
        return counted(static_cast<std::size_t>(bytes), "byte");
    const std::uintmax_t kilobytes = (bytes + kilo / 2) / kilo;
    if (kilobytes < kilo)
        return std::to_string(kilobytes) + " KB";
    return rounded_text(std::round(static_cast<double>(kilobytes) / 100) / 10) + " MB";
}

std::uintmax_t written_bytes(const std::filesystem::path& file)
{
    std::error_code is_no_file;
    const std::uintmax_t bytes = std::filesystem::file_size(file, is_no_file);
    return is_no_file ? 0 : bytes;
}

std::string written_picture_text(const std::filesystem::path& output, const std::string& contents, Size size,
                                 std::uintmax_t bytes)
{
    return output.string() + ": " + contents + ", " + size_text(size) + ", " + file_size_text(bytes);
}

}
