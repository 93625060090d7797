#include "host/commands/command.hpp"
#include "host/commands/devices/device_options.hpp"
#include "host/commands/flash/flash_job.hpp"
#include "host/commands/flash/flash_report.hpp"
#include "host/commands/import/import_options.hpp"
#include "host/commands/options/option_facts.hpp"
#include "host/commands/options/option_groups.hpp"
#include "host/commands/text/json_text.hpp"
#include "host/config/firmware_images.hpp"
#include "host/fit/other_hardware.hpp"
#include "host/link/device_address.hpp"
#include "host/program/failure.hpp"
#include "host/program/interruption.hpp"
#include "host/text/characters.hpp"
#include "host/text/suggestion.hpp"

#include <array>
#include <functional>
#include <iostream>
#include <memory>

namespace kfast {
namespace {

struct FlashOptions {
    PlanWish plan;
    PlaceWish place;
    BootLines lines;
    DeviceOptions talk;
    std::string board = "pico";
    bool dry_run = false;
    bool verify_only = false;
    bool no_wait = false;
    bool list = false;
};

constexpr std::array<std::string_view, 1> boards{"pico"};

std::string mistaken_board(const std::string& board)
{
    if (board == boards.front())
        return {};
    if (const auto text = fit::other_board_text(board))
        return "'" + board + "': " + *text;
    return "there is no firmware for '" + board + "': " + suggestion(board, boards);
}

std::string mistaken_device(const std::string& serial)
{
    if (!is_simulated(serial))
        return {};
    return "flash needs a board of its own; 'kfast play' and 'kfast upload' reach the simulator with "
           "--device " +
           visible(serial);
}

FlashOrder order_of(const FlashOptions& options)
{
    FlashOrder order{.place = options.place, .last_patience = last_patience(options.talk)};
    if (options.dry_run)
        order.purpose = FlashPurpose::dry_run;
    if (options.verify_only)
        order.purpose = FlashPurpose::verify_only;
    if (!options.lines.reset.empty())
        order.lines = options.lines;
    return order;
}

std::optional<Failure> failure_of(const std::function<void()>& act)
{
    try {
        act();
        return std::nullopt;
    } catch (const Failure& failure) {
        return failure;
    }
}

/// A scene that was flashed and does not play was refused by the player.
void require_playing(const FlashPlan& plan, const PlayerOutcome& player)
{
    if (plan.has_scene() && !player.playing.is_playing)
        throw Failure{player.name + ": plays nothing, though it has the scene: its display and its LED tell "
                                    "why (docs/config.md)",
                      ExitStatus::refused};
}

void report(const FlashOptions& options, const std::string& text)
{
    if (!options.talk.json && !options.talk.quiet)
        std::cout << text << std::flush;
}

void print_json(const FlashOptions& options, const FlashOutcome& outcome,
                const std::optional<PlayerOutcome>& player)
{
    if (options.talk.json)
        std::cout << json_text(flash_json(outcome, player)) << std::flush;
}

void see_it_play(const FlashOptions& options, const FlashPlan& plan, FlashJob& job,
                 const FlashOutcome& outcome)
{
    std::optional<PlayerOutcome> player;
    const std::optional<Failure> failure = failure_of([&] { player = job.await_player(); });
    print_json(options, outcome, player);
    if (failure)
        throw Failure{*failure};
    report(options, player_text(*player));
    require_playing(plan, *player);
}

void flash(const FlashOptions& options)
{
    const FlashPlan plan{options.plan, config::image_folders()};
    const FlashOrder order = order_of(options);
    const std::unique_ptr<FlashEnvironment> environment = host_flash_environment();
    std::optional<FlashProgress> progress{shown_progress(options.talk)};
    const FlashProgressCallback on_progress = [&](FlashPhase phase, std::size_t done, std::size_t total) {
        progress->report(phase, done, total);
    };
    const RememberedInterruption interruption;
    FlashJob job{*environment, plan, order, on_progress};
    const FlashOutcome outcome = job.run();
    progress.reset();
    report(options, flash_text(outcome, order.purpose));
    if (outcome.restarted && order.purpose == FlashPurpose::write && !options.no_wait)
        see_it_play(options, plan, job, outcome);
    else
        print_json(options, outcome, std::nullopt);
}

void run(const FlashOptions& options)
{
    if (options.list)
        print_flash_list(*host_flash_environment(), options.talk.json ? ListForm::json : ListForm::text);
    else
        flash(options);
}

void declare_contents(CLI::App& app, FlashOptions& options)
{
    reads_scene(
        app.add_option("SCENE", options.plan.scene, std::string{"The built-in scene. "} + loaded_scene));
    declare_settings_options(app, options.plan.settings);
    const OptionHeading heading{app, option_group::contents};
    CLI::Option* const firmware =
        app.add_option("--firmware", options.plan.firmware,
                       "The .bin of a firmware (default: the installed one for the bus of the display)")
            ->type_name("FILE");
    reads_file(firmware, {".bin"});
    app.add_flag("--no-firmware", options.plan.no_firmware, "Leave the firmware that the board has")
        ->excludes(firmware);
}

void declare_place(CLI::App& app, FlashOptions& options)
{
    app.add_option("--board", options.board, "The kind of the board: pico, which is usual")
        ->type_name("NAME")
        ->check(CLI::Validator{mistaken_board, ""})
        ->group(option_group::board);
    const OptionHeading heading{app, option_group::boot};
    CLI::Option* const port =
        app.add_option("--port", options.place.port, "The board in its boot loader at this port, like 1-2.3")
            ->type_name("PORT");
    CLI::Option* const serial = app.add_option("--device", options.place.serial,
                                               "The board that runs KFAST and has this serial number")
                                    ->type_name("SERIAL")
                                    ->check(CLI::Validator{mistaken_device, ""})
                                    ->excludes(port)
                                    ->group(option_group::device);
    CLI::Option* const drive =
        app.add_option("--drive", options.place.drive,
                       "The folder of the drive RPI-RP2: writes to it, which cannot be verified")
            ->type_name("FOLDER")
            ->excludes(port)
            ->excludes(serial);
    names_folder(drive);
    CLI::Option* const reset = app.add_option("--reset-line", options.lines.reset,
                                              "The GPIO line of this computer that is wired to RUN")
                                   ->type_name("LINE")
                                   ->excludes(serial)
                                   ->excludes(drive);
    CLI::Option* const boot =
        app.add_option("--boot-line", options.lines.boot, "The GPIO line that is wired to BOOTSEL")
            ->type_name("LINE")
            ->needs(reset);
    reset->needs(boot);
    app.add_option(
           "--gpio-chip", options.lines.chip,
           "The chip of the GPIO lines: its path, name or label (default: the one with the first line)")
        ->type_name("CHIP")
        ->needs(reset);
}

void declare_flash(CLI::App& app)
{
    const auto options = std::make_shared<FlashOptions>();
    declare_contents(app, *options);
    declare_place(app, *options);
    CLI::Option* const dry_run =
        app.add_flag("--dry-run", options->dry_run, "Print what would be done, and touch nothing");
    app.add_flag("--verify-only", options->verify_only, "Compare, and write nothing: status 10 if it differs")
        ->excludes(dry_run);
    app.add_flag("--no-wait", options->no_wait, "Do not wait until the board plays");
    app.add_flag("--list", options->list, "List the boards that could be flashed");
    declare_talk_options(app, options->talk);
    app.callback([options] { run(*options); });
}

}

const Command flash_command{.name = "flash",
                            .summary =
                                "Put firmware, settings and a scene on a board by USB, and see it play",
                            .example = "kfast flash eyes.kfast --panel gc9a01 --pin dc=8",
                            .declare = declare_flash,
                            .group = board_group};

}
