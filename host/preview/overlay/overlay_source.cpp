#include "host/preview/overlay/overlay_source.hpp"

#include "host/preview/board/board_changes.hpp"
#include "host/preview/board/previewed_board.hpp"
#include "host/preview/overlay/overlay_marks.hpp"
#include "host/preview/overlay/painted_items.hpp"
#include "host/preview/overlay/posed_scene.hpp"
#include "host/preview/overlay/seen_strokes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace kfast {
namespace {

constexpr double near = 6; ///< pixels around a line of a beam

double distance(PanelSpot spot, PanelSpot from, PanelSpot to)
{
    const double x = to.x - from.x;
    const double y = to.y - from.y;
    const double length = x * x + y * y;
    const double share =
        length > 0 ? std::clamp(((spot.x - from.x) * x + (spot.y - from.y) * y) / length, 0.0, 1.0) : 0;
    return std::hypot(spot.x - from.x - share * x, spot.y - from.y - share * y);
}

double distance(const Viewport& viewport, PanelSpot spot, const std::vector<SeenStroke>& strokes)
{
    double min = near;
    for (const SeenStroke& stroke : strokes)
        for (std::size_t i = 1; i < stroke.line.size(); ++i)
            min = std::min(min,
                           distance(spot, viewport.spot(stroke.line[i - 1]), viewport.spot(stroke.line[i])));
    return min;
}

bool is_selected(const SeenLeaf& leaf, const ViewOptions& view)
{
    return view.selected && std::ranges::find(leaf.numbers, *view.selected) != leaf.numbers.end();
}

}

struct OverlaySource::Parts {
    Viewport viewport;
    PosedScene posed{viewport.scene, viewport.posed_panel(), viewport.posed_fit()};
    BoardChanges changes{viewport.scene, viewport.board ? *viewport.board : previewed_board({viewport.panel}),
                         viewport.fit};
    PaintedItems painted{viewport.scene, viewport.panel, viewport.fit};

    std::array<InputReceiver*, 2> players() { return {&changes, &painted}; }

    void add_marks(Time moment, const ViewOptions& view, double scale, Overlay& overlay);
    void add_changes(Time moment, Overlay& overlay);
    std::optional<std::size_t> painted_at(Time moment, PanelSpot spot);
    std::optional<std::size_t> drawn_near(Time moment, PanelSpot spot);
};

void OverlaySource::Parts::add_marks(Time moment, const ViewOptions& view, double scale, Overlay& overlay)
{
    OverlayMarks marks{viewport, posed, scale, overlay};
    posed.visit(moment, [&](const SeenLeaf& leaf) {
        if (view.bones)
            marks.add_bones(leaf);
        if (view.numbers && (!view.selected || is_selected(leaf, view)))
            marks.add_numbers(leaf);
        else if (is_selected(leaf, view))
            marks.add_outline(leaf);
    });
    if (view.bones)
        marks.add_other_bones();
}

void OverlaySource::Parts::add_changes(Time moment, Overlay& overlay)
{
    const SentAreas& sent = changes.show(moment);
    for (const Rect& area : sent.areas)
        overlay.areas.push_back({area, MarkKind::changed_area});
    overlay.facts = sent.text(viewport.panel);
}

std::optional<std::size_t> OverlaySource::Parts::painted_at(Time moment, PanelSpot spot)
{
    const auto path =
        painted.path_at(moment, static_cast<int>(std::floor(spot.x)), static_cast<int>(std::floor(spot.y)));
    std::optional<std::size_t> number;
    if (path)
        posed.visit(moment, [&](const SeenLeaf& leaf) {
            if (leaf.path == *path)
                number = leaf.number();
        });
    return number;
}

std::optional<std::size_t> OverlaySource::Parts::drawn_near(Time moment, PanelSpot spot)
{
    std::optional<std::size_t> number;
    double min = near;
    posed.visit(moment, [&](const SeenLeaf& leaf) {
        const double found = distance(viewport, spot, seen_strokes(posed, leaf));
        if (found < near && found <= min) {
            min = found;
            number = leaf.number();
        }
    });
    return number;
}

OverlaySource::OverlaySource(const Viewport& viewport) : parts_{new Parts{viewport}} {}

OverlaySource::~OverlaySource() = default;

const Overlay& OverlaySource::show(Time moment, const ViewOptions& view, double scale)
{
    overlay_ = {};
    if (view.changed_areas && !parts_->viewport.is_beam)
        parts_->add_changes(moment, overlay_);
    if (view.bones || view.numbers || view.selected)
        parts_->add_marks(moment, view, scale, overlay_);
    return overlay_;
}

std::optional<std::size_t> OverlaySource::item_at(Time moment, PanelSpot spot)
{
    return parts_->viewport.is_beam ? parts_->drawn_near(moment, spot) : parts_->painted_at(moment, spot);
}

ItemFacts OverlaySource::facts(Time moment, std::size_t item)
{
    PosedScene& posed = parts_->posed;
    const std::optional<ItemView> view = posed.item(item);
    if (!view)
        return {};
    const SceneTime at = posed.at(moment);
    return facts_at(posed.on_panel(), *view, at);
}

bool OverlaySource::set(std::uint32_t number, const InputContent& content)
{
    for (InputReceiver* const player : parts_->players())
        player->set(number, content);
    return give_input(parts_->posed, number, content);
}

}
