#include "host/fit/fit_report.hpp"

#include "core/scene/item_view.hpp"
#include "core/scene/scene_view.hpp"
#include "host/fit/speed.hpp"
#include "host/fit/wording.hpp"
#include "host/text/number_text.hpp"
#include "host/walk/every_item.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <span>
#include <string>

namespace kfast::fit {

namespace {

/// The names of the objects of a scene, by their paths (core/scene/item_view.hpp).
class ItemLabels {
public:
    /// `names` are those of the items in the order in which the scene stores them, or none.
    ItemLabels(const SceneView& scene, std::span<const std::string> names);

    /// "gaze/left-eye/shape"; "object 3" if it has no name, "" if there is no such object.
    std::string operator[](std::uint32_t path) const;

private:
    struct Outer {
        std::uint32_t path = 0;
        std::string label;
    };

    void add(ItemCursor items, const Outer& outer);

    const SceneView& scene_;
    std::map<const std::byte*, StoredItem> items_;
    std::map<std::uint32_t, std::string> labels_; ///< by the paths of objects
};

ItemLabels::ItemLabels(const SceneView& scene, std::span<const std::string> names)
    : scene_{scene}, items_{stored_items(scene, names)}
{
    add(scene.items(), {});
}

void ItemLabels::add(ItemCursor items, const Outer& outer)
{
    while (!items.at_end()) {
        const ItemView item = items.next();
        Outer inner{path_to(scene_.place_of(item.place), outer.path), outer.label};
        const std::string& name = items_.at(item.place).name;
        if (!name.empty())
            inner.label += (inner.label.empty() ? "" : "/") + name;
        if (item.is_leaf())
            labels_[inner.path] = inner.label;
        else
            add(scene_.items_in(item), inner);
    }
}

std::string ItemLabels::operator[](std::uint32_t path) const
{
    const auto label = labels_.find(path);
    return label == labels_.end() ? "" : label->second;
}

std::string excess(const std::string& what, std::size_t needed, std::size_t available,
                   const std::string& parts)
{
    return what + ": " + bytes_text(needed) + " are needed (" + parts + "), " + std::to_string(available) +
           " are there: " + std::to_string(needed - available) + " too many";
}

void check_flash(const FitReport& report, const Target& target, std::vector<std::string>& shortages)
{
    const FlashNeed& need = report.flash;
    if (need.sum() > target.flash)
        shortages.push_back(excess("flash", need.sum(), target.flash, parts_text(need)));
}

void check_ram(const FitReport& report, const Target& target, std::vector<std::string>& shortages)
{
    const RamNeed& need = report.ram;
    if (need.sum() <= target.ram)
        return;
    const LargestOutlines& outlines = report.speed.outlines;
    shortages.push_back(excess("RAM", need.sum(), target.ram, parts_text(need, "bands")) +
                        "; the largest outlines are those of frame " + frame_text(outlines.moment) + ", " +
                        bytes_text(outlines.bytes) + ", of which " + std::to_string(outlines.item_bytes) +
                        " are of " + report.largest_object);
}

void check_bands(const Target& target, std::vector<std::string>& shortages)
{
    const std::size_t min = min_band(target.display);
    if (target.band_bytes >= min)
        return;
    const auto rows = static_cast<std::size_t>(target.display.granularity.height);
    shortages.push_back("bands: each has " + bytes_text(target.band_bytes) + ", but " + counted(rows, "row") +
                        " of the panel " + (rows == 1 ? "takes " : "take ") + std::to_string(min));
}

void check_outlines(const FitReport& report, std::vector<std::string>& shortages)
{
    if (!report.speed.overfull)
        return;
    const LargestOutlines& outlines = *report.speed.overfull;
    shortages.push_back(
        "outlines: those of frame " + frame_text(outlines.moment) +
        " find no room with the coarsest curves either, parts of the picture are missing; of the " +
        bytes_text(outlines.bytes) + " that found room " + std::to_string(outlines.item_bytes) + " are of " +
        report.overfull_object);
}

/// What has to be reduced for more frames: pixels that change, or what there is to compute.
std::string bottleneck_of(const FitReport& report, const FrameCost& frame)
{
    if (frame.bus_seconds > frame.cpu_seconds)
        return "the bus takes longest, " + milliseconds_text(frame.bus_seconds) + " for " +
               bytes_text(frame.bytes);
    std::string text = "the processor takes longest";
    if (!report.heaviest_object.empty())
        text += ", in the worst frame " + std::to_string(std::lround(report.speed.heaviest.share * 100)) +
                " % of it for " + report.heaviest_object;
    return text;
}

/// "60 fps leave 16.7 ms for each"
std::string room_text(double rate)
{
    return rate_text(rate) + " leave " + milliseconds_text(1 / rate) + " for each";
}

bool is_too_long(double seconds, const FitReport& report) { return seconds * report.wanted_rate > slack; }

std::string slowness_of(const FitReport& report)
{
    const FrameCost& median = report.speed.median();
    if (is_too_long(median.seconds(), report))
        return "speed: every second frame takes " + milliseconds_text(median.seconds()) + " or more, but " +
               room_text(report.wanted_rate) + "; " + rate_text(1 / median.seconds()) +
               " can be reached: " + bottleneck_of(report, median);
    if (report.late_with_inputs.is_all())
        return "speed: while its inputs move all pictures are late, the worst takes " +
               milliseconds_text(std::ranges::max(report.speed.busy_turn)) + ", but " +
               room_text(report.wanted_rate) + ": " + bottleneck_of(report, report.speed.worst());
    return {};
}

std::string hang_of(const FitReport& report, const Target& target)
{
    const FrameCost* dearest = &report.speed.first;
    for (const FrameCost& frame : report.speed.frames)
        if (frame.cpu_seconds > dearest->cpu_seconds)
            dearest = &frame;
    return watchdog_reason(dearest->cpu_seconds, dearest->moment, target);
}

void note_bus(const Target& target, std::vector<std::string>& notes)
{
    const Display& display = target.display;
    if (target.bus.kind == BusKind::spi && display.rated_spi != 0 && target.bus.clock > display.rated_spi)
        notes.push_back("the maker of the " + std::string{display.name} + " allows " +
                        frequency_text(display.rated_spi) + " on its bus; here it runs at " +
                        frequency_text(target.bus.clock));
}

void note_stride(const FitReport& report, std::vector<std::string>& notes)
{
    if (report.speed.stride > 1)
        notes.push_back("the scene is long: one frame of " + std::to_string(report.speed.stride) +
                        " was looked at");
}

/// Missing parts are a shortage: check_outlines().
void note_coarse_pictures(const FitReport& report, std::vector<std::string>& notes)
{
    if (const std::size_t coarse = report.speed.coarse_pictures)
        notes.push_back(std::to_string(coarse) + " of " + counted(report.speed.frames.size(), "picture") +
                        " have coarser curves, for their outlines find no room: a smaller panel has it, or a "
                        "scene of fewer curves");
}

/// A program has every feature unless it names those of its scene.
void note_features(const FitReport& report, const Target& target, std::vector<std::string>& notes)
{
    const std::size_t rest = costs_of(target.processor).code - report.flash.player;
    if (rest != 0 && report.flash.sum() <= target.flash && report.flash.sum() + rest > target.flash)
        notes.push_back("it fits if the program has only what the scene needs of the player, not all of it, "
                        "which takes " +
                        bytes_text(rest) + " more: docs/library.md, \"Only what a scene needs\"");
}

/// Where a computer cannot set an input anew for every frame.
void note_link(const FitReport& report, std::vector<std::string>& notes)
{
    for (const LinkUpdate& update : report.link)
        if (update.max_per_second() * slack < report.wanted_rate)
            notes.push_back("telling " + update.what + " takes " + counted(update.reports, "report") +
                            ", so that " + rate_text(update.max_per_second()) + " can be told by USB, not " +
                            rate_text(report.wanted_rate));
}

void judge(const Target& target, FitReport& report)
{
    check_flash(report, target, report.shortages);
    check_ram(report, target, report.shortages);
    check_bands(target, report.shortages);
    check_outlines(report, report.shortages);
    report.hang = hang_of(report, target);
    report.slowness = slowness_of(report);
    note_bus(target, report.notes);
    note_stride(report, report.notes);
    note_coarse_pictures(report, report.notes);
    note_features(report, target, report.notes);
    note_link(report, report.notes);
}

}

std::vector<std::string> FitReport::reasons() const
{
    std::vector<std::string> reasons = shortages;
    for (const std::string& reason : {hang, slowness})
        if (!reason.empty())
            reasons.push_back(reason);
    return reasons;
}

std::string FitReport::lateness_text() const
{
    const bool is_by_inputs = late.late == 0 && late_with_inputs.late != 0;
    const std::string text = late_text(is_by_inputs ? late_with_inputs : late);
    if (text.empty() && is_too_long(speed.leap, *this))
        return "late while its inputs leap: at worst " + rate_text(1 / speed.leap) + " of " +
               rate_text(wanted_rate);
    if (text.empty())
        return {};
    return text + (speed.stride > 1 ? " of those looked at" : "") +
           (is_by_inputs ? " while its inputs move" : "");
}

FitReport fit_report(const FitWish& wish)
{
    FitReport report;
    report.flash = flash_need(wish.scene, wish.target);
    report.ram = ram_need(wish.scene, wish.target);
    report.speed = measured_speed(wish.scene, wish.target, wish.fit, wish.stop, wish.on_progress);
    report.link = link_need(wish.scene);
    report.wanted_rate =
        wish.frames_per_second != 0 ? wish.frames_per_second : wish.scene.frame_rate() / 1000.0;
    report.late = lateness(report.speed.turn, report.wanted_rate);
    report.late_with_inputs = lateness(report.speed.busy_turn, report.wanted_rate);
    const ItemLabels labels{wish.scene, wish.item_names};
    report.heaviest_object = labels[report.speed.heaviest.path];
    report.largest_object = labels[report.speed.outlines.path];
    if (report.speed.overfull)
        report.overfull_object = labels[report.speed.overfull->path];
    judge(wish.target, report);
    return report;
}

}
