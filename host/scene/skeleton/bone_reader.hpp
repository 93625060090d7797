#pragma once

#include "host/geometry/outline.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"
#include "host/schema/node_form.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kfast::scene {

inline constexpr std::string_view bone_name = "bone";

/// A bone as it is written: on the canvas.
struct WrittenBone {
    const kdl::Node* node = nullptr;
    std::string name;
    SourceSpan place; ///< of "bone" and the name
    Vec2 from;
    Vec2 to;
    std::optional<double> region;
    std::optional<bool> tip;
    const kdl::Value* parent_name = nullptr;
    std::optional<std::size_t> parent; ///< index among those that were read
    bool is_valid = true;              ///< nothing in it was wrong except its parent's name
};

/// Reads the bones of one skeleton.
class BoneReader {
public:
    explicit BoneReader(SceneContext& context) : context_{context} {}

    /// Adds `node`, a bone, and all inside of it; reports what is wrong.
    void read(const kdl::Node& node) { read(node, std::nullopt); }
    /// Finds the parents that are given by name. Reports those that are not there.
    std::vector<WrittenBone> take();
    /// Whether those that were read, and their parents, are all valid.
    bool is_valid() const { return is_valid_; }

private:
    void read(const kdl::Node& node, std::optional<std::size_t> parent);
    WrittenBone read_bone(const kdl::Node& node, std::optional<std::size_t> parent);
    bool has_capacity(const WrittenBone& bone);
    void find_parent(WrittenBone& bone);

    SceneContext& context_;
    std::vector<WrittenBone> bones_;
    NameTable names_;
    bool is_valid_ = true;
    bool is_full_ = false; ///< has been reported
};

NodeSchema bone_schema();

/// The bone that is called `name`; reports it at `place` if there is none.
std::optional<std::size_t> read_bone_name(std::string_view name, SourceSpan place,
                                          const std::vector<Bone>& bones, SceneContext& context);

}
