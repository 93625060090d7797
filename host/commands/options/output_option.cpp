#include "host/commands/options/output_option.hpp"
#include "host/commands/options/option_groups.hpp"

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
    return app.add_option("-o,--output", output, help)->type_name("OUT")->check(CLI::Validator{mistake, ""});
}

}
