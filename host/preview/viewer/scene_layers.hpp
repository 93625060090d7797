#pragma once

#include "host/preview/board/board_changes.hpp"
#include "host/preview/board/fit_check.hpp"
#include "host/preview/overlay/onion_skin.hpp"
#include "host/preview/overlay/overlay_source.hpp"
#include "host/preview/playback/preview_playback.hpp"
#include "host/preview/playback/time_table.hpp"
#include "host/preview/viewer/opened_scene.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace kfast {

/// What is shown of a scene besides its pictures.
class SceneLayers {
public:
    /// `scene` must outlive it.
    explicit SceneLayers(OpenedScene& scene);

    const TimeTable& table() const { return table_; }
    /// With the quantities of what is unfolded. Valid until the next call.
    const TimeTable& table(const std::set<std::size_t>& unfolded);
    /// Where `playback` stands, with its inputs; `scale` as in OverlaySource. Valid until the next call.
    const Overlay& overlay(const PreviewPlayback& playback, const ViewOptions& view, double scale);
    std::optional<std::size_t> item_at(const PreviewPlayback& playback, PanelSpot spot);
    ItemFacts facts(const PreviewPlayback& playback, std::size_t item);
    /// With the key frames before and after it within what is played: those of the selected item and of what
    /// lies in it, or of all. Likewise.
    const Picture& onion_skin(const PreviewPlayback& playback, std::optional<std::size_t> selected);
    /// What the board takes for the picture of a moment after the one that was asked for before, with the
    /// inputs of `playback`. Not on a beam.
    double board_seconds(const PreviewPlayback& playback, Time moment);
    /// Its name.
    std::string board_name() const { return board().name; }
    /// Nothing while it is being made, which the first call begins.
    std::optional<std::span<const FitLine>> fit_report();

private:
    Viewport viewport() const;
    fit::Target board() const;
    std::vector<Time> skin_keys(PlayRange played, std::optional<std::size_t> selected) const;

    OpenedScene& scene_;
    TimeTable table_;
    TimeTable unfolded_table_;
    std::set<std::size_t> unfolded_;
    std::unique_ptr<BoardPace> pace_;
    OverlaySource overlays_;
    OnionSkin skin_;
    std::vector<InputKnob> skin_inputs_; ///< with which the skin's pictures were made
    bool skin_reveals_travel_ = false;   ///< likewise
    std::unique_ptr<FitCheck> fit_;
};

}
