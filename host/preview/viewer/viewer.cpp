#include "host/preview/viewer/viewer.hpp"

#include "host/fit/wording.hpp"
#include "host/picture/png.hpp"
#include "host/preview/files/written_files.hpp"
#include "host/preview/viewer/viewer_selection.hpp"
#include "host/program/failure.hpp"
#include "host/text/characters.hpp"
#include "host/text/number_text.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

namespace kfast {
namespace {

namespace fs = std::filesystem;

std::unique_ptr<PreviewPlayback> played(const OpenedScene& scene, Viewer::Seconds now,
                                        std::optional<int> loops)
{
    return std::make_unique<PreviewPlayback>(scene.playback_setup, scene.source->pace(), now, loops);
}

/// Whether `key` makes other pictures of the frames than those that were generated.
bool changes_frames(PreviewKey key)
{
    switch (key) {
    case PreviewKey::next_clip:
    case PreviewKey::previous_clip:
    case PreviewKey::more_input:
    case PreviewKey::less_input:
    case PreviewKey::loop:
    case PreviewKey::travel:
        return true;
    default:
        return false;
    }
}

}

Viewer::Viewer(Opener opener, std::unique_ptr<OpenedScene> scene, Seconds now, std::optional<int> loops)
    : reader_{std::move(opener), *scene}, loops_{loops}
{
    auto playback = played(*scene, now, loops);
    auto layers = std::make_unique<SceneLayers>(*scene);
    put({std::move(scene), std::move(layers)}, std::move(playback), now);
}

Viewer::~Viewer() = default;

void Viewer::press(PreviewKey key, Seconds now)
{
    if (is_working())
        return stop_work();
    notice_.clear();
    if (changes_frames(key))
        all_frames_.reset();
    const bool steps = all_frames_ && key == PreviewKey::play_pause;
    playback_->press(steps ? PreviewKey::next_frame : key, now);
    kfast::press(view_, key);
    act(key, now);
}

void Viewer::act(PreviewKey key, Seconds now)
{
    switch (key) {
    case PreviewKey::read_file:
        return ask_for_file(now);
    case PreviewKey::all_frames:
        return generate_all_frames();
    case PreviewKey::next_item:
        return select(item_beside(view_.selected, 1, time_table()));
    case PreviewKey::previous_item:
        return select(item_beside(view_.selected, -1, time_table()));
    case PreviewKey::edit:
        return edit();
    case PreviewKey::quantities:
        return fold_selected();
    case PreviewKey::board_speed:
        return play_as_board(!view_.board_speed, now);
    case PreviewKey::screenshot:
        return write_screenshot();
    case PreviewKey::gif:
        return begin_gif();
    default: // of the playback or the view
        return;
    }
}

bool Viewer::attend(Seconds now)
{
    playback_->advance_to(now);
    if (is_working()) {
        go_on_working();
        return true;
    }
    if (const std::string failure = editor_ ? editor_->take_failure() : ""; !failure.empty())
        notify(failure);
    const bool has_chosen = take_chosen_file(now);
    const bool has_read = read_what_changed(now);
    const bool had_report = std::exchange(has_report_, fit_report().has_value());
    return has_chosen || has_read || has_report_ != had_report;
}

void Viewer::scrub(Time moment) { playback_->scrub(moment); }

void Viewer::select(std::optional<std::size_t> item) { view_.selected = item; }

void Viewer::play_as_board(bool as_board, Seconds now)
{
    view_.board_speed = as_board;
    set_pace(now);
}

/// Sets the pace of what is played now.
void Viewer::set_pace(Seconds now)
{
    if (!view_.board_speed)
        return playback_->pace_by({}, now);
    if (shown_.scene->is_beam) {
        view_.board_speed = false;
        return notify("only boards with a panel set the speed here: kfast fit shows what a beam can do");
    }
    const auto seconds = [this](Time moment) { return shown_.layers->board_seconds(*playback_, moment); };
    playback_->pace_by(seconds, now);
}

void Viewer::set_zoom(int zoom)
{
    view_.zoom = zoom;
    playback_->close_help();
    notice_.clear();
}

void Viewer::set_on_event(PreviewPlayback::OnEvent on_event)
{
    on_event_ = std::move(on_event);
    playback_->set_on_event(on_event_);
}

void Viewer::close()
{
    stop_work();
    is_closed_ = true;
}

void Viewer::notify(std::string notice)
{
    notice_ = std::move(notice);
    ++notice_number_;
}

void Viewer::put(ReadScene scene, std::unique_ptr<PreviewPlayback> playback, Seconds now)
{
    stop_work();
    all_frames_.reset();
    facts_.clear();
    playback_ = std::move(playback);
    playback_->set_on_event(on_event_);
    std::swap(shown_, scene); // layers before their scene, when the old ones go
    if (view_.board_speed)
        set_pace(now);
    const std::string& warnings = shown_.scene->warnings;
    if (!warnings.empty())
        notify(warnings.substr(0, warnings.find('\n')));
}

void Viewer::open(const fs::path& file, Seconds now)
{
    stop_work();
    notice_.clear();
    ReadScene scene = reader_.open(file);
    if (!scene)
        return;
    auto playback = played(*scene.scene, now, loops_);
    playback->close_help();
    view_.selected.reset();
    view_.unfolded.clear();
    put(std::move(scene), std::move(playback), now);
}

void Viewer::reload(Seconds now)
{
    notice_.clear();
    ReadScene scene = reader_.read_again();
    if (!scene)
        return;
    auto playback = played(*scene.scene, now, loops_);
    playback->continue_from(*playback_, now);
    const auto selected = name_of(view_.selected, time_table());
    const auto unfolded = names_of(view_.unfolded, time_table());
    notify(reader_.file().filename().string() + " is read again");
    put(std::move(scene), std::move(playback), now);
    view_.selected = selected ? item_of(*selected, time_table()) : std::nullopt;
    view_.unfolded = items_of(unfolded, time_table());
}

bool Viewer::read_what_changed(Seconds now)
{
    const auto file = reader_.changed(now);
    if (!file)
        return false;
    if (*file == reader_.file())
        reload(now);
    else
        open(*file, now);
    return true;
}

void Viewer::ask_for_file(Seconds now)
{
    if (chooser_ == nullptr)
        return open(fs::path{shown_.scene->file}, now);
    try {
        if (!chooser_->is_asking())
            chooser_->ask(shown_.scene->file.parent_path());
        notify("choose a file in the dialogue");
    } catch (const Failure& failure) {
        notify(failure.what());
    }
}

bool Viewer::take_chosen_file(Seconds now)
{
    if (chooser_ == nullptr || !chooser_->is_asking())
        return false;
    try {
        const auto file = chooser_->take_answer();
        if (!chooser_->is_asking())
            notice_.clear();
        if (file)
            open(*file, now);
    } catch (const Failure& failure) {
        notify(failure.what());
    }
    return !chooser_->is_asking();
}

void Viewer::write_screenshot()
{
    try {
        const fs::path target = new_output_name(shown_.scene->file, frame_suffix(playback_->frame()), ".png");
        write_png(target, widen(frame()));
        notify(target.string() + " is written");
    } catch (const Failure& failure) {
        notify(failure.what());
    }
}

const Frame& Viewer::frame()
{
    FrameSource& source = *shown_.scene->source;
    const auto* const drawn = all_frames_ ? all_frames_->at(playback_->time()) : nullptr;
    if (drawn == nullptr) {
        const Frame& frame = show(source, *playback_);
        facts_ = source.facts();
        return frame;
    }
    apply_playback(source, *playback_);
    source.accompany(playback_->time());
    facts_ = drawn->facts;
    return drawn->frame;
}

const Picture& Viewer::picture()
{
    if (!view_.onion_skin) {
        picture_ = widen(frame());
        return picture_;
    }
    const Picture& skinned = shown_.layers->onion_skin(*playback_, view_.selected);
    facts_ = shown_.scene->source->facts();
    return skinned;
}

const Overlay& Viewer::overlay(double scale) { return shown_.layers->overlay(*playback_, view_, scale); }

std::optional<std::span<const FitLine>> Viewer::fit_report()
{
    return view_.fit_report ? shown_.layers->fit_report() : std::nullopt;
}

std::optional<std::size_t> Viewer::item_at(PanelSpot spot)
{
    return shown_.layers->item_at(*playback_, spot);
}

std::string Viewer::status() const
{
    std::string status = playback_->status();
    if (playback_->reveals_travel() && !facts_.empty())
        status += "  " + facts_;
    if (all_frames_ && all_frames_->is_complete())
        status += "  all frames";
    if (view_.board_speed) {
        status += "  as on " + shown_.layers->board_name();
        constexpr double rounding = 0.001; // times that are added up come to a little less than they are
        if (const auto rate = playback_->board_rate())
            status += ": " + fit::rate_text(*rate + rounding);
    }
    if (view_.selected)
        status += "  selected " + visible(selected_name());
    return status + in_words(view_);
}

}
