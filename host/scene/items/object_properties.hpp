#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"
#include "host/scene/values/item_values.hpp"
#include "host/scene/values/key_driver.hpp"
#include "host/schema/node_form.hpp"

#include <optional>

namespace kfast::scene {

/// The properties of an object's node.
struct ObjectProperties {
    ItemValues values;
    KeyDriver driver; ///< of its keys
    FillRule fill_rule = FillRule::nonzero;
    StrokeStyle stroke; ///< without colour and width, which are among `values`
    BeamStyle beam;
    const kdl::Value* skin = nullptr;  ///< the name of a skeleton
    const kdl::Value* bone = nullptr;  ///< the name of the only bone that deforms the object
    const kdl::Value* bones = nullptr; ///< the names of those whose regions count
    bool turns_changes = false;        ///< see Skin
    const kdl::Value* live = nullptr;  ///< the name of the input that is shown instead of drawings

    std::optional<std::size_t> fill_colour() const;
    std::optional<StrokeStyle> stroke_style() const;
};

/// Reports what is wrong; a lack of both fill and stroke at `place`.
ObjectProperties read_object_properties(const kdl::Node& node, SourceSpan place, SceneContext& context);

std::vector<PropertySchema> object_property_schema();

}
