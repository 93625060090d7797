#include "host/scene/skeleton/bone_name_reader.hpp"

#include "host/scene/context/skeleton_table.hpp"
#include "host/text/glyph.hpp"
#include "host/text/suggestion.hpp"

namespace kfast::scene {

std::optional<std::size_t> read_bone_name(std::string_view name, SourceSpan place,
                                          const std::vector<Bone>& bones, SceneContext& context)
{
    const auto bone = find_bone(bones, name);
    if (!bone)
        context.report.error(place, "unknown bone " + in_quotes(name), suggestion(name, names_of(bones)));
    return bone;
}

}
