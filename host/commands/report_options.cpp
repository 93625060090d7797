#include "host/commands/report_options.hpp"

namespace kfast {

CLI::Option* declare_json(CLI::App& app, bool& json)
{
    return app.add_flag("--json", json, "Print JSON, for programs");
}

CLI::Option* declare_quiet(CLI::App& app, bool& quiet)
{
    return app.add_flag("-q,--quiet", quiet, "Print nothing but errors");
}

}
