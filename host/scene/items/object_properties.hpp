#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"
#include "host/scene/values/item_values.hpp"
#include "host/scene/values/key_driver.hpp"
#include "host/schema/node_form.hpp"

#include <optional>

namespace kfast::scene {

/// What the node of an object says itself.
struct ObjectProperties {
    ItemValues values;
    KeyDriver driver; ///< of its keys
    FillRule fill_rule = FillRule::nonzero;
    StrokeStyle stroke; ///< but for colour and width, which are among `values`
    BeamStyle beam;
    const kdl::Value* skin = nullptr; ///< the name of a skeleton
    const kdl::Value* bone = nullptr; ///< the name of the bone that alone carries the object
    bool turns_changes = false;       ///< see Skin
    const kdl::Value* live = nullptr; ///< the name of the input that is shown instead of drawings

    std::optional<std::size_t> fill_colour() const;
    std::optional<StrokeStyle> stroke_style() const;
};

/// Reports what is wrong; that there is neither fill nor stroke at `place`.
ObjectProperties read_object_properties(const kdl::Node& node, SourceSpan place, SceneContext& context);

std::vector<PropertySchema> object_property_words();

}
