#include "host/commands/command.hpp"
#include "host/commands/import/import_options.hpp"
#include "host/commands/inputs/input_options.hpp"
#include "host/commands/options/option_facts.hpp"
#include "host/commands/options/option_groups.hpp"
#include "host/commands/options/play_options.hpp"
#include "host/commands/render/wired_panel_options.hpp"
#include "host/commands/text/quantity_text.hpp"
#include "host/compile/scene_file.hpp"
#include "host/config/mistake_text.hpp"
#include "host/picture/player_source.hpp"
#include "host/program/interruption.hpp"
#include "host/wired/panel_show.hpp"

#include <iostream>

namespace kfast {
namespace {

struct PanelOptions {
    std::string scene;
    WiredPanelOptions panel;
    PlayOptions play;
    InputOptions inputs;
    DrawingOptions drawings;
    std::optional<std::uint64_t> frames;
};

class PlayerInputs final : public InputReceiver {
public:
    explicit PlayerInputs(SceneState& player) : player_{player} {}

    bool set(std::uint32_t number, const InputContent& content) override
    {
        return give_input(player_, number, content);
    }

private:
    SceneState& player_;
};

PanelShow show_of(const PanelOptions& options, const BoardSettings& settings, const SceneFile& scene)
{
    const InputValues values = chosen_values(options.inputs, options.drawings, scene.view);
    PlayerSource trial{scene.view, settings.panel.size(), Fit::contain, PixelFormat::rgb565};
    put_values(values, scene.view, trial); // a mistake is to be reported before the display is touched
    return {.panel = settings.panel,
            .scene = scene.bytes,
            .timeline = chosen_timeline(options.play, scene.view),
            .apply_inputs =
                [values, &scene](SceneState& player) {
                    PlayerInputs receiver{player};
                    put_values(values, scene.view, receiver);
                },
            .frames = options.frames};
}

void say_begin(const WiredPanelOptions& options, const BoardSettings& settings, const SpiDevice* spi)
{
    const Size size = settings.panel.size();
    std::cout << options.panel->name << ", " << size.width << 'x' << size.height;
    if (spi != nullptr)
        std::cout << ", on " << options.spi << " at " << clock_text(spi->clock()) << ", " << spi->piece()
                  << " bytes at once";
    else
        std::cout << ", on eight GPIO lines";
    std::cout << std::endl;
    if (const auto warning = spi != nullptr ? config::clock_warning(settings) : std::nullopt)
        std::cerr << "kfast: the clock is " << warning->message
                  << ": many bear it; if the picture is torn or speckled, take --clock "
                  << clock_text(config::rated_clock(settings)) << "\n";
}

ShownFrames show_on(const PanelOptions& options, const BoardSettings& settings, const PanelShow& show)
{
    const WiredPanelOptions& wires = options.panel;
    if (settings.bus != BusKind::spi) {
        PanelLines lines{wires.chip, wires.lines};
        say_begin(wires, settings, nullptr);
        return show_on_parallel(show, lines);
    }
    SpiDevice spi{{.path = wires.spi,
                   .clock = settings.bus_clock,
                   .mode = wires.spi_mode,
                   .drives_select = !wires.lines.contains(LineRole::select)}};
    PanelLines lines{wires.chip, wires.lines};
    say_begin(wires, settings, &spi);
    return show_on_spi(show, spi, lines);
}

void show(const PanelOptions& options)
{
    const BoardSettings settings = chosen_wired_panel(options.panel);
    const SceneFile scene = load_scene(options.scene);
    const PanelShow what = show_of(options, settings, scene);
    const RememberedInterruption remembered;
    const ShownFrames frames = show_on(options, settings, what);
    std::cout << frames.shown << " frames shown, " << frames.left_out << " left out\n";
}

void declare_panel(CLI::App& app)
{
    const auto options = std::make_shared<PanelOptions>();
    reads_scene(app.add_option("SCENE", options->scene, loaded_scene))->required();
    declare_wired_panel_options(app, options->panel);
    declare_play_options(app, options->play);
    declare_input_options(app, options->inputs);
    declare_drawing_options(app, options->drawings);
    app.add_option("--frames", options->frames, "End after so many (default: Ctrl-C ends it)")
        ->type_name("N")
        ->check(number_within(1, 1e9))
        ->group(option_group::play);
    app.callback([options] { show(*options); });
}

}

const Command panel_command{"panel",
                            "Play a scene on a display that is wired to this computer (docs/panel.md)",
                            "kfast panel eyes.kfast --panel st7789 --spi /dev/spidev0.0 --clock 40MHz \\\n"
                            "      --pin dc=GPIO25 --pin reset=GPIO27 --pin backlight=GPIO24",
                            declare_panel,
                            {},
                            elsewhere_group};

}
