#include "host/compiler/limits/outline_needs.hpp"

#include "core/scene/item_view.hpp"
#include "core/scene/kfb_limits.hpp"
#include "core/scene/scene_view.hpp"
#include "core/time/time.hpp"
#include "host/compiler/limits/allowance.hpp"
#include "host/compiler/limits/clock_phases.hpp"
#include "host/compiler/limits/measured_moments.hpp"
#include "host/compiler/limits/outline_meter.hpp"
#include "host/compiler/write/header.hpp"
#include "host/scene/model.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/text/diagnostic.hpp"
#include "host/walk/outline_items.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

namespace kfast {

namespace {

/// Enough for any picture that a file can hold, with the coarsest curves.
constexpr std::size_t ample_bytes = 16 * std::size_t{kfb::max_outline_bytes};

/// The live object that may have the most points.
class LargestLive {
public:
    explicit LargestLive(const scene::Scene& scene) : scene_{scene}
    {
        for (const scene::Symbol& symbol : scene.symbols)
            add(symbol.items);
        add(scene.items);
    }

    /// Its location in the text of the scene.
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

/// Reports that the outlines at `moment`, with these texts, exceed what the format allows, at the object that
/// has most of them. `view` is `scene` compiled.
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
    const std::string meeting = moment.clocks().empty() ? "" : ", with symbols at times that may meet,";
    diagnostics.error(item.place,
                      "the outlines at frame " + scene::text_of(moment.time()) + meeting + " need " +
                          std::to_string(needed) + " bytes, " + std::to_string(needed - held) +
                          " more than the format holds; object \"" + item.name + "\" alone needs " +
                          std::to_string(max),
                      "draw it with fewer points, or show less at a time");
}

/// Reports the same if the worst live drawings, `live` bytes, come on top of `bytes` of others; at the one
/// that may have the most points.
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

constexpr std::size_t min_bytes = 64;
constexpr std::size_t min_moments = 64; ///< that are measured, however long it takes

std::uint32_t with_reserve(std::size_t bytes)
{
    const std::size_t wanted = (bytes + bytes / 8 + min_bytes) / 4 * 4;
    return static_cast<std::uint32_t>(std::min<std::size_t>(wanted, kfb::max_outline_bytes));
}

/// Each chain is a border in every band that it reaches.
std::size_t borders_of(const raster::OutlineStore& outlines)
{
    constexpr int band_rows = 1 << raster::default_band_bits;
    std::size_t borders = 0;
    outlines.each_chain([&borders](const raster::Chain& chain) {
        const int first = raster::floor_pixel(chain.top) / band_rows;
        const int last = std::max(raster::ceil_pixel(chain.bottom) - 1, 0) / band_rows;
        borders += static_cast<std::size_t>(std::max(last - first, 0)) + 1;
    });
    return borders;
}

/// Borders that live drawings may need: one for every 16 bytes, as in scenes.
std::size_t live_borders(std::size_t bytes) { return bytes / 16; }

std::uint32_t borders_with_reserve(std::size_t borders)
{
    constexpr std::size_t min = 16;
    const std::size_t wanted = borders + borders / 16 + min;
    return static_cast<std::uint32_t>(std::min<std::size_t>(wanted, kfb::max_borders));
}

/// Measures the pictures of a scene, and keeps the most that any needs.
class Measurement {
public:
    /// `view` is `scene` compiled. Both, the meter of it and `diagnostics` must outlive this.
    Measurement(const scene::Scene& scene, const SceneView& view, OutlineMeter& meter,
                Diagnostics& diagnostics)
        : scene_{scene}, view_{view}, meter_{meter}, diagnostics_{diagnostics}
    {
    }

    /// What the picture at this moment needs; reported, and not enough if it is more than the format holds.
    /// `texts` are those that the meter shows.
    std::size_t measure(const MeasuredMoment& measured, const LargestTexts& texts)
    {
        const raster::Picture& picture = meter_.picture_at(measured.moment());
        const raster::OutlineStore& outlines = picture.outlines;
        const std::size_t live = meter_.live_bytes();
        const std::size_t bytes = outlines.needed_bytes() + live;
        is_refused_ = outlines.is_full() || bytes > kfb::max_outline_bytes;
        if (outlines.is_full()) {
            report_excess(scene_, view_, measured.moment(), texts, diagnostics_);
        } else if (is_refused_) {
            report_live_excess(scene_, measured.moment(), outlines.needed_bytes(), live, diagnostics_);
        } else {
            if (bytes > bytes_)
                largest_ = measured;
            bytes_ = std::max(bytes_, bytes);
            borders_ = std::max(borders_, borders_of(outlines) + live_borders(live));
            cache_bytes_ = std::max(cache_bytes_, picture.cache.bytes_in_use());
        }
        return bytes;
    }

    bool is_refused() const { return is_refused_; }
    /// The one that needs most.
    const MeasuredMoment& largest() const { return largest_; }
    OutlineNeeds needs() const
    {
        return {.bytes = with_reserve(bytes_),
                .borders = borders_with_reserve(borders_),
                .cache_bytes =
                    static_cast<std::uint32_t>(std::min<std::size_t>(cache_bytes_, kfb::max_cache_bytes))};
    }

private:
    const scene::Scene& scene_;
    const SceneView& view_;
    OutlineMeter& meter_;
    Diagnostics& diagnostics_;
    MeasuredMoment largest_;
    std::size_t bytes_ = 0;
    std::size_t borders_ = 0;
    std::size_t cache_bytes_ = 0;
    bool is_refused_ = false;
};

}

std::optional<OutlineNeeds> outline_needs(std::vector<std::byte> file, const scene::Scene& scene,
                                          Diagnostics& diagnostics, const ProgressCallback& on_progress)
{
    set_outline_needs(file, {.bytes = kfb::max_outline_bytes});
    const auto view = playable(file, scene, diagnostics);
    if (!view)
        return std::nullopt;
    OutlineMeter meter{*view, kfb::max_outline_bytes};
    std::vector<MeasuredMoment> moments = measured_moments(*view);
    const std::vector<LargestTexts> all_texts = largest_texts(*view, moments, meter);
    const std::size_t pictures = affordable_pictures(*view, peak_bytes(moments, meter));
    const std::size_t with_each = std::max(pictures / all_texts.size(), min_moments);
    thin_out(moments, with_each);
    const ClockPhases phases{*view};
    Measurement measurement{scene, *view, meter, diagnostics};
    const std::size_t steps = all_texts.size() * moments.size();
    std::size_t done = 0;
    for (const LargestTexts& texts : all_texts) {
        put_texts(texts, meter);
        const auto bytes_at = [&](const MeasuredMoment& moment) {
            return measurement.is_refused() ? 0 : measurement.measure(moment, texts);
        };
        for (const MeasuredMoment& measured : moments) {
            on_progress(done++, steps);
            bytes_at(measured);
        }
        if (phases.are_varied())
            phases.vary(measurement.largest(), with_each, bytes_at);
    }
    return measurement.is_refused() ? std::nullopt : std::optional{measurement.needs()};
}

}
