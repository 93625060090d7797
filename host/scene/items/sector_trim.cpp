#include "host/scene/items/sector_trim.hpp"

#include "core/math/stroke_trimmer.hpp"
#include "host/geometry/arc.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

namespace kfast::scene {
namespace {

constexpr double full_turn = 360;

/// Whether all strokes are sectors of one form.
bool has_only(SectorForm form, const Key& key)
{
    return key.sectors.size() == key.drawing.strokes.size() &&
           std::ranges::all_of(key.sectors,
                               [form](const SectorStroke& stroke) { return stroke.form == form; });
}

bool is_circular(const Sector& sector) { return sector.radius_x == sector.radius_y; }

bool have_equal_angles(const Sector& a, const Sector& b) { return a.from == b.from && a.to == b.to; }

/// Whether a key draws at least one sector, all of one form, of circles, and between the same angles.
bool is_uniform(const Key& key, SectorForm form)
{
    if (key.sectors.empty() || !has_only(form, key))
        return false;
    const Sector& first = key.sectors.front().sector;
    return std::ranges::all_of(key.sectors, [&](const SectorStroke& stroke) {
        return is_circular(stroke.sector) && have_equal_angles(stroke.sector, first);
    });
}

const Sector& sector_of(const Key& key) { return key.sectors.front().sector; }

bool are_replaceable(const std::vector<Key>& keys)
{
    if (keys.empty() || keys.front().sectors.empty())
        return false;
    const SectorForm form = keys.front().sectors.front().form;
    const auto fits = [&](const Key& key) {
        return is_uniform(key, form) && key.sectors.size() == keys.front().sectors.size();
    };
    const auto moves = [&](const Key& key) {
        return !have_equal_angles(sector_of(key), sector_of(keys.front()));
    };
    return form != SectorForm::ring_piece && std::ranges::all_of(keys, fits) &&
           std::ranges::any_of(keys, moves);
}

/// From the smallest angle that a key reaches to the largest.
struct AngleRange {
    double min = 0;
    double max = 0;
};

AngleRange angles_of(const std::vector<Key>& keys)
{
    AngleRange angles{sector_of(keys.front()).from, sector_of(keys.front()).from};
    for (const Key& key : keys) {
        angles.min = std::min({angles.min, sector_of(key).from, sector_of(key).to});
        angles.max = std::max({angles.max, sector_of(key).from, sector_of(key).to});
    }
    return angles;
}

/// Which part of what is drawn is seen at a key, in shares of it.
struct Window {
    double from = 0;
    double to = 0;
    double offset = 0;
};

/// The range of angles that all keys draw, and how a key's angles are written in it.
struct Trimmed {
    double from = 0;
    double to = 0;
    bool is_full_circle = false; ///< then windows have an offset, so that they may go around

    Window window_of(const Sector& sector) const
    {
        const double range = to - from;
        if (!is_full_circle)
            return {(sector.from - from) / range, (sector.to - from) / range, 0};
        return {0, std::abs(sector.to - sector.from) / range,
                (std::min(sector.from, sector.to) - from) / range};
    }
};

/// Nothing if no range of at most a turn will do.
std::optional<Trimmed> trimmed_range(const std::vector<Key>& keys)
{
    const AngleRange angles = angles_of(keys);
    if (angles.max - angles.min <= full_turn)
        return Trimmed{angles.min, angles.max};
    const auto runs_clockwise = [](const Key& key) { return sector_of(key).from <= sector_of(key).to; };
    const auto runs_back = [](const Key& key) { return sector_of(key).from >= sector_of(key).to; };
    if (!std::ranges::all_of(keys, runs_clockwise) && !std::ranges::all_of(keys, runs_back))
        return std::nullopt;
    const double from = sector_of(keys.front()).from;
    return Trimmed{from, from + full_turn, true};
}

Outline outline_of(SectorForm form, const Sector& sector)
{
    return form == SectorForm::pie ? pie(sector) : arc(sector);
}

/// Nothing if one of them would reach beyond the range of coordinates.
std::optional<Drawing> drawing_of(const Key& key, const Trimmed& trimmed)
{
    Drawing drawing;
    for (const SectorStroke& stroke : key.sectors) {
        Sector sector = stroke.sector;
        sector.from = trimmed.from;
        sector.to = trimmed.to;
        const Outline outline = outline_of(stroke.form, sector);
        if (!in_range(outline))
            return std::nullopt;
        drawing.strokes.push_back(quantized(outline));
    }
    return drawing;
}

/// Nothing if one of them would reach beyond the range of coordinates.
std::optional<std::vector<Drawing>> drawings_of(const std::vector<Key>& keys, const Trimmed& trimmed)
{
    std::vector<Drawing> drawings;
    for (const Key& key : keys) {
        auto drawing = drawing_of(key, trimmed);
        if (!drawing)
            return std::nullopt;
        drawings.push_back(std::move(*drawing));
    }
    return drawings;
}

Track track_of(Property property, const std::vector<Key>& keys, Driver driver, const Trimmed& trimmed,
               double Window::*share)
{
    Track track{.property = property, .keys = {}, .driver = driver};
    for (const Key& key : keys) {
        const double value = trimmed.window_of(sector_of(key)).*share;
        track.keys.push_back(
            {key.time, key.laws, static_cast<std::int32_t>(std::lround(value * path_whole)), key.place});
    }
    const std::int32_t first = track.keys.front().value;
    if (std::ranges::all_of(track.keys, [first](const TrackKey& key) { return key.value == first; }))
        track.keys = {{.time = {}, .laws = {}, .value = first}};
    return track;
}

/// Keys whose drawings are all the same are one.
void put_drawings(std::vector<Key>& keys, std::vector<Drawing> drawings)
{
    const bool are_equal = std::ranges::adjacent_find(drawings, std::not_equal_to{}) == drawings.end();
    for (std::size_t i = 0; i < keys.size(); ++i) {
        keys[i].drawing = std::move(drawings[i]);
        keys[i].sectors.clear();
    }
    if (!are_equal)
        return;
    keys.resize(1);
    keys.front().laws = {};
}

}

bool are_pies(const std::vector<Key>& keys)
{
    const auto is_pie = [](const Key& key) { return has_only(SectorForm::pie, key); };
    return std::ranges::any_of(keys, [](const Key& key) { return !key.sectors.empty(); }) &&
           std::ranges::all_of(keys, is_pie);
}

Track trim_by_angles()
{
    constexpr auto mode = static_cast<std::int32_t>(TrimMode::sector);
    return {.property = Property::trim_mode, .keys = {{.time = {}, .laws = {}, .value = mode}}};
}

std::vector<Track> trim_sectors(std::vector<Key>& keys, Driver driver)
{
    if (!are_replaceable(keys))
        return {};
    const auto trimmed = trimmed_range(keys);
    auto drawings = trimmed ? drawings_of(keys, *trimmed) : std::nullopt;
    if (!drawings)
        return {};
    std::vector<Track> tracks;
    tracks.push_back(track_of(Property::trim_from, keys, driver, *trimmed, &Window::from));
    tracks.push_back(track_of(Property::trim_to, keys, driver, *trimmed, &Window::to));
    tracks.push_back(track_of(Property::trim_offset, keys, driver, *trimmed, &Window::offset));
    if (are_pies(keys))
        tracks.push_back(trim_by_angles());
    put_drawings(keys, std::move(*drawings));
    return tracks;
}

}
