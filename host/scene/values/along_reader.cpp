#include "host/scene/values/along_reader.hpp"

#include "host/geometry/outline.hpp"
#include "host/scene/context/limits.hpp"
#include "host/scene/values/path_reader.hpp"

#include <string>

namespace kfast::scene {

std::optional<Path> read_along_path(const kdl::Value& data, SceneContext& context)
{
    const auto outlines = read_path_data(data, max_points, context);
    if (!outlines)
        return std::nullopt;
    if (outlines->size() > 1) {
        context.report.error(data.place,
                             "an item follows one stroke; this path has " + std::to_string(outlines->size()),
                             "leave out all M but the first, and what is behind Z");
        return std::nullopt;
    }
    Path path;
    if (!outlines->empty())
        path.stroke = quantized(outlines->front());
    if (!path.stroke.segments.empty())
        return path;
    context.report.error(data.place, "this path leads nowhere", "write one such as \"M 20 20 L 80 20\"");
    return std::nullopt;
}

}
