#include "host/compiler/limits/outline_excess.hpp"

#include "core/scene/item_view.hpp"
#include "core/scene/kfb_limits.hpp"
#include "host/compiler/limits/outline_meter.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/walk/outline_items.hpp"

#include <algorithm>
#include <string>

namespace kfast {
namespace {

/// Enough for any picture that a file can hold, with the coarsest curves.
constexpr std::size_t ample_bytes = 16 * std::size_t{kfb::max_outline_bytes};

/// The live object that may have most points.
class LargestLive {
public:
    explicit LargestLive(const scene::Scene& scene) : scene_{scene}
    {
        for (const scene::Symbol& symbol : scene.symbols)
            add(symbol.items);
        add(scene.items);
    }

    /// Where it stands in the text of the scene.
    SourceSpan place() const { return place_; }

private:
    void add(const std::vector<scene::Item>& items)
    {
        for (const scene::Item& item : items) {
            if (const auto* group = std::get_if<scene::Group>(&item.content))
                add(group->items);
            const auto* object = std::get_if<scene::Object>(&item.content);
            if (object != nullptr && object->live)
                add(item, scene_.inputs[*object->live].drawing.points);
        }
    }

    void add(const scene::Item& item, std::size_t points)
    {
        if (points > points_)
            place_ = item.place;
        points_ = std::max(points_, points);
    }

    const scene::Scene& scene_;
    SourceSpan place_;
    std::size_t points_ = 0;
};

/// Finds an object of a scene by its path (core/scene/item_view.hpp).
class ObjectSearch {
public:
    ObjectSearch(const scene::Scene& scene, const SceneView& view, std::uint32_t path)
        : scene_{scene}, view_{view}, path_{path}
    {
    }

    const scene::Item* found() { return found_among(scene_.items, view_.items(), 0); }

private:
    const scene::Item* found_among(const std::vector<scene::Item>& items, ItemCursor views,
                                   std::uint32_t outer)
    {
        for (const scene::Item& item : items)
            if (const scene::Item* const found = found_in(item, views.next(), outer))
                return found;
        return nullptr;
    }

    const scene::Item* found_in(const scene::Item& item, const ItemView& view, std::uint32_t outer)
    {
        const std::uint32_t path = path_to(view_.place_of(view.place), outer);
        if (const auto* group = std::get_if<scene::Group>(&item.content))
            return found_among(group->items, ItemCursor{view.items}, path);
        if (const auto* use = std::get_if<scene::Use>(&item.content))
            return found_among(scene_.symbols[use->symbol].items, view_.symbol(view.symbol), path);
        return path == path_ ? &item : nullptr;
    }

    const scene::Scene& scene_;
    const SceneView& view_;
    std::uint32_t path_;
};

}

void report_excess(const scene::Scene& scene, const SceneView& view, const SceneTime& moment,
                   const LargestTexts& texts, Diagnostics& diagnostics)
{
    OutlineMeter meter{view, ample_bytes};
    put_texts(texts, meter);
    const raster::Picture& picture = meter.picture_at(moment);
    constexpr std::size_t held = kfb::max_outline_bytes;
    const std::size_t needed = std::max(picture.outlines.needed_bytes(), held);
    const auto by_item = outline_bytes_by_item(picture);
    const auto& [path, max] =
        *std::ranges::max_element(by_item, {}, [](const auto& item) { return item.second; });
    const scene::Item& item = *ObjectSearch{scene, view, path}.found();
    diagnostics.error(item.place,
                      "the outlines at frame " + scene::text_of(moment.time()) + " need " +
                          std::to_string(needed) + " bytes, " + std::to_string(needed - held) +
                          " more than the format holds; object \"" + item.name + "\" alone needs " +
                          std::to_string(max),
                      "draw it with fewer points, or show less at a time");
}

void report_live_excess(const scene::Scene& scene, const SceneTime& moment, std::size_t bytes,
                        std::size_t live, Diagnostics& diagnostics)
{
    diagnostics.error(LargestLive{scene}.place(),
                      "what is told from outside may need " + std::to_string(live) +
                          " bytes of outlines at frame " + scene::text_of(moment.time()) +
                          ", everything else needs " + std::to_string(bytes) + " bytes; the format holds " +
                          std::to_string(kfb::max_outline_bytes),
                      "let the input have fewer points, or use join=bevel");
}

}
