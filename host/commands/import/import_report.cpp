#include "host/commands/import/import_report.hpp"

#include "host/commands/text/json_text.hpp"
#include "host/commands/text/quantity_text.hpp"
#include "host/text/characters.hpp"
#include "host/text/number_text.hpp"

#include <algorithm>

namespace kfast {
namespace {

using Json = nlohmann::ordered_json;

Json losses_of(const art::Losses& losses)
{
    Json list = Json::array();
    for (const art::Loss& loss : losses.list()) {
        list.push_back(
            {{"feature", loss.feature}, {"layer", loss.layer}, {"time", nullptr}, {"instead", loss.instead}});
        if (loss.time)
            list.back()["time"] = *loss.time;
    }
    return list;
}

/// Of the longer side: 1/16 px of it is half a pixel on common displays.
constexpr int coarse_canvas = 32;

std::string advice(const ImportReport& report)
{
    if (report.is_size_chosen || std::max(report.canvas.width, report.canvas.height) > coarse_canvas)
        return "";
    return "the canvas is small, and places are rounded to 1/16 px: --canvas 240x240 keeps more of its "
           "shapes\n";
}

}

std::string import_text(const ImportReport& report, importing::ListLength length)
{
    const importing::Extent& extent = report.imported.extent;
    std::string text = report.scene + ": " + counted(extent.figures, "object") + ", " +
                       counted(extent.keys, "key") + ", " + counted(extent.points, "point") + "; " +
                       counted(report.imported.compiled.bytes.size(), "byte") + " compiled, " +
                       counted(report.block_bytes, "byte") + " of memory at " + size_text(report.canvas) +
                       '\n';
    for (const std::string& note : report.imported.notes)
        text += visible(note) + '\n';
    const art::Losses& losses = report.imported.losses;
    if (losses.empty())
        return text + advice(report) + "all is carried over\n";
    return text + advice(report) + importing::loss_count(losses) + ":\n" +
           importing::loss_list(losses, length) + '\n';
}

std::string import_json(const ImportReport& report)
{
    const importing::Imported& imported = report.imported;
    return json_text(
        {{"file", report.file},
         {"scene", report.scene},
         {"objects", imported.extent.figures},
         {"groups", imported.extent.groups},
         {"keys", imported.extent.keys},
         {"points", imported.extent.points},
         {"bytes", imported.compiled.bytes.size()},
         {"memory",
          {{"bytes", report.block_bytes}, {"width", report.canvas.width}, {"height", report.canvas.height}}},
         {"notes", imported.notes},
         {"losses", losses_of(imported.losses)},
         {"more_losses", imported.losses.beyond()}});
}

}
