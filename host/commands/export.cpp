#include "host/commands/command.hpp"
#include "host/commands/export/export_kinds.hpp"
#include "host/commands/import/import_options.hpp"
#include "host/commands/options/beam_options.hpp"
#include "host/commands/options/option_facts.hpp"
#include "host/commands/options/option_groups.hpp"
#include "host/commands/options/output_options.hpp"

#include <array>
#include <memory>
#include <vector>

namespace kfast {
namespace {

namespace fs = std::filesystem;

using Options = std::vector<CLI::Option*>;

/// A kind of file, and what its flag does.
struct Kind {
    CLI::Option* flag;
    void (*run)(const ExportOptions&);
};

Kind add_kind(CLI::Option_group& kinds, const char* flag, const char* text, void (*run)(const ExportOptions&))
{
    return {kinds.add_flag(flag)->description(text), run};
}

void belong_to(const Kind& kind, const Options& options)
{
    for (CLI::Option* option : options)
        option->needs(kind.flag);
}

Options declare_header_options(CLI::App& app, ExportOptions& options)
{
    const OptionHeading heading{app, option_group::output};
    CLI::Option* name =
        app.add_option_function<std::string>(
               "--array-name", [&options](const std::string& text) { options.name = checked_c_name(text); },
               "With --header: what the array is called (default: FILE's name)")
            ->type_name("NAME");
    declare_size_options(app, options.picture);
    return {name, app.get_option("--size"), app.get_option("--panel")};
}

Options declare_ilda_options(CLI::App& app, ExportOptions& options)
{
    const OptionHeading heading{app, option_group::output};
    return {app.add_option("--ilda-format", options.ilda_format,
                           "With --ild: 0 3-D and indexed, 1 2-D and indexed, 4 3-D and true colour, 5 2-D "
                           "and true colour (default: 5)")
                ->type_name("N")
                ->check(one_of({0, 1, 4, 5}))};
}

Options declare_wave_options(CLI::App& app, ExportOptions& options)
{
    const OptionHeading heading{app, option_group::sound};
    Options all = declare_sound_options(app, options.sound);
    all.push_back(app.add_option("--bits", options.bits, "With --wav: of a sample, 16 or 24 (default: 16)")
                      ->type_name("N")
                      ->check(one_of({16, 24})));
    all.push_back(app.add_option("--seconds", options.seconds,
                                 "With --wav: how long, by playing again (default: one play)")
                      ->type_name("T")
                      ->check(number_within(0.001, 86400)));
    return all;
}

/// Of what is drawn for a beam.
Options declare_beam_options(CLI::App& app, ExportOptions& options)
{
    CLI::Option* beam = declare_beam_option(app, options.beam);
    declare_play_options(app, options.play);
    declare_input_options(app, options.picture.inputs);
    declare_drawing_options(app, options.picture.drawings);
    return {beam, app.get_option("--clip"), app.get_option("--speed"), app.get_option("--input"),
            app.get_option("--drawing")};
}

std::array<Kind, 3> declare_kinds(CLI::App& app)
{
    const OptionHeading heading{app, option_group::what_to_make};
    CLI::Option_group& group = *app.add_option_group(option_group::what_to_make);
    group.require_option(1);
    return {add_kind(group, "--header", "An array in a header for C and C++", export_header),
            add_kind(group, "--ild", "An ILDA file with the frames of one play, for lasers", export_ilda),
            add_kind(group, "--wav", "A sound that leads an oscilloscope: x left, y right", export_wave)};
}

void declare_export(CLI::App& app)
{
    const auto options = std::make_shared<ExportOptions>();
    reads_scene(app.add_option("FILE", options->scene, loaded_scene))->required();
    const auto kinds = declare_kinds(app);
    declare_output(app, options->output, "The file (default: FILE's name with .h, .ild or .wav)");
    belong_to(kinds[0], declare_header_options(app, *options));
    belong_to(kinds[1], declare_ilda_options(app, *options));
    belong_to(kinds[2], declare_wave_options(app, *options));
    for (CLI::Option* option : declare_beam_options(app, *options))
        option->excludes(kinds[0].flag);
    declare_quiet(app, options->quiet);
    app.callback([options, kinds] {
        for (const auto& [flag, run] : kinds)
            if (flag->count() > 0)
                run(*options);
    });
}

}

fs::path export_path(const ExportOptions& options, const char* ending)
{
    const fs::path output =
        options.output.empty() ? fs::path{options.scene}.replace_extension(ending) : fs::path{options.output};
    return output_path(output, options.scene);
}

const Command export_command{"export",
                             "Turn a scene into source for programs, an ILDA file or a sound for a scope",
                             "kfast export --header eyes.kfast -o eyes.h\n"
                             "  kfast export --ild eyes.kfast --beam galvo\n"
                             "  kfast export --wav eyes.kfast --sample-rate 96000 --seconds 60",
                             declare_export,
                             {},
                             elsewhere_group};

}
