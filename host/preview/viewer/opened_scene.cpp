#include "host/preview/viewer/opened_scene.hpp"

#include "host/preview/board/previewed_board.hpp"

#include <algorithm>
#include <exception>
#include <sstream>
#include <utility>

namespace kfast {

namespace {

bool are_equal(const std::vector<InputKnob>& a, const std::vector<InputKnob>& b)
{
    return std::ranges::equal(a, b, [](const InputKnob& one, const InputKnob& other) {
        return one.value == other.value && one.text == other.text;
    });
}

}

SceneLayers::SceneLayers(OpenedScene& scene)
    : scene_{scene},
      table_{time_table(scene.scene.view, scene.scene.item_names)},
      overlays_{viewport()},
      skin_{scene.scene.view.colour(0)}
{
    if (scene.apply_drawings)
        scene.apply_drawings(overlays_);
}

const Overlay& SceneLayers::overlay(const PreviewPlayback& playback, const ViewOptions& view, double scale)
{
    apply_inputs(overlays_, playback);
    return overlays_.show(playback.time(), view, scale);
}

std::optional<std::size_t> SceneLayers::item_at(const PreviewPlayback& playback, PanelSpot spot)
{
    apply_inputs(overlays_, playback);
    return overlays_.item_at(playback.time(), spot);
}

ItemFacts SceneLayers::facts(const PreviewPlayback& playback, std::size_t item)
{
    apply_inputs(overlays_, playback);
    return overlays_.facts(playback.time(), item);
}

std::vector<Time> SceneLayers::skin_keys(PlayRange played, std::optional<std::size_t> selected) const
{
    std::vector<Time> keys = selected ? table_.keys_of(*selected) : scene_.playback_setup.keys;
    std::erase_if(keys, [&](Time key) { return key < played.begin || key > played.end; });
    return keys;
}

const Picture& SceneLayers::onion_skin(const PreviewPlayback& playback, std::optional<std::size_t> selected)
{
    if (!are_equal(skin_inputs_, playback.inputs()) || skin_reveals_travel_ != playback.reveals_travel()) {
        skin_.forget();
        skin_inputs_ = playback.inputs();
        skin_reveals_travel_ = playback.reveals_travel();
    }
    apply_playback(*scene_.source, playback);
    return skin_.show(*scene_.source, playback.time(), skin_keys(playback.stretch(), selected));
}

std::optional<std::span<const FitLine>> SceneLayers::fit_report()
{
    if (fit_ == nullptr)
        fit_ = std::make_unique<FitCheck>(scene_.scene.bytes, scene_.scene.item_names, board(), scene_.fit);
    return fit_->lines();
}

fit::Target SceneLayers::board() const
{
    return scene_.board ? *scene_.board : previewed_board({scene_.panel});
}

double SceneLayers::board_seconds(const PreviewPlayback& playback, Time moment)
{
    if (pace_ == nullptr) {
        pace_ = std::make_unique<BoardPace>(scene_.scene.view, board(), scene_.fit);
        if (scene_.apply_drawings)
            scene_.apply_drawings(pace_->inputs());
    }
    apply_inputs(pace_->inputs(), playback);
    return pace_->seconds_for(moment);
}

const TimeTable& SceneLayers::table(const std::set<std::size_t>& unfolded)
{
    if (unfolded.empty())
        return table_;
    if (unfolded != unfolded_) {
        unfolded_table_ = with_quantities(table_, unfolded);
        unfolded_ = unfolded;
    }
    return unfolded_table_;
}

Viewport SceneLayers::viewport() const
{
    return {scene_.scene.view, scene_.panel, scene_.fit, scene_.is_beam, scene_.board};
}

namespace {

namespace fs = std::filesystem;

std::vector<std::string> lines_of(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream rest{text};
    for (std::string line; std::getline(rest, line);)
        lines.push_back(line);
    return lines;
}

}

SceneReader::SceneReader(Opener opener, const OpenedScene& first)
    : opener_{std::move(opener)}, tried_{first.file}, errors_{lines_of(first.mistakes)}
{
    if (!errors_.empty()) {
        failed_ = Failed{first.file, first.read};
        return;
    }
    file_ = first.file;
    watch_ = first.read;
}

ReadScene SceneReader::open(const fs::path& file)
{
    FileWatch tried{{file}};
    ReadScene read_now = read(file, tried);
    if (!read_now)
        failed_ = Failed{file, std::move(tried)};
    return read_now;
}

ReadScene SceneReader::read_again()
{
    FileWatch tried;
    return read(fs::path{file_}, tried);
}

std::optional<fs::path> SceneReader::changed(Seconds now)
{
    if (failed_ && failed_->watch.has_changed(now))
        return failed_->file;
    if (watch_.has_changed(now))
        return file_;
    return std::nullopt;
}

ReadScene SceneReader::read(const fs::path& file, FileWatch& tried)
{
    errors_.clear();
    tried_ = file;
    try {
        ReadScene read_now{opener_(file), nullptr};
        read_now.layers = std::make_unique<SceneLayers>(*read_now.scene);
        failed_.reset();
        file_ = file;
        watch_ = read_now.scene->read;
        return read_now;
    } catch (const OpeningFailed& failure) {
        errors_ = lines_of(failure.what());
        tried = failure.read();
        return {};
    } catch (const std::exception& failure) { // in any case, the open scene can continue
        errors_ = lines_of(failure.what());
        return {};
    }
}

}
