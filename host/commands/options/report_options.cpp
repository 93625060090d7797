#include "host/commands/options/report_options.hpp"
#include "host/commands/options/option_groups.hpp"
#include "host/commands/text/size_text.hpp"
#include "host/text/counted.hpp"
#include "host/text/rounded_text.hpp"

#include <cmath>
#include <iostream>
#include <system_error>

namespace kfast {

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
