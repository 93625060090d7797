#include "host/scene/values/font_reader.hpp"

#include "host/program/failure.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/text/glyph.hpp"

#include <algorithm>
#include <filesystem>
#include <string>

namespace kfast::scene {
namespace {

bool is_bundled(std::string_view name)
{
    return std::ranges::find(FontShelf::bundled_names(), name) != FontShelf::bundled_names().end();
}

/// The name of a file ends at U+0000.
bool names_file(std::string_view name)
{
    return name.find_first_of("./") != std::string_view::npos && name.find('\0') == std::string_view::npos;
}

bool leads_out(const std::filesystem::path& path)
{
    return path.is_absolute() || std::ranges::find(path, "..") != path.end();
}

/// Whether there may be a file of that name for this scene.
bool may_be_read(const kdl::Value& value, std::string_view name, SceneContext& context)
{
    if (!names_file(name))
        return context.report.error(value.place, "unknown font " + in_quotes(name),
                                    suggestion(name, FontShelf::bundled_names()) +
                                        " (a font file beside the scene is named as \"Sans.ttf\")");
    if (leads_out(name))
        return context.report.error(value.place, "a font file lies in the folder of the scene or below it",
                                    "copy it there, and write its path from there");
    return context.fonts.has_folder() ||
           context.report.error(value.place, "this scene is no file, so there are no files beside it",
                                suggestion("", FontShelf::bundled_names()));
}

}

Font* read_font(const kdl::Value& value, SceneContext& context)
{
    const auto name = read_text(value, context.report);
    if (!name || (!is_bundled(*name) && !may_be_read(value, *name, context)))
        return nullptr;
    try {
        return &context.fonts.font(std::string{*name});
    } catch (const Failure& failure) {
        context.report.error(value.place, visible(failure.what()));
        return nullptr;
    }
}

}
