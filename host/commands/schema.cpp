#include "host/commands/command.hpp"
#include "host/commands/help/schema_json.hpp"
#include "host/commands/help/schema_kdl.hpp"
#include "host/commands/help/schema_markdown.hpp"
#include "host/commands/options/report_options.hpp"

#include <iostream>
#include <memory>

namespace kfast {
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
