#pragma once

#include "core/time/time.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"
#include "host/scene/values/key_driver.hpp"
#include "host/scene/values/law_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/report.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kfast::scene {

inline constexpr std::string_view pose_name = "pose";

/// How a pose sets one bone; what is not given is as set up.
struct PosedBone {
    std::size_t bone = 0;
    std::optional<double> turn; ///< from the direction as set up, in degrees, clockwise
    std::optional<double> x;    ///< of the origin, in pixels from where it is as set up, in the directions of
    std::optional<double> y;    ///< the canvas as set up
    std::optional<double> length; ///< in pixels
    SourceSpan place;
};

/// A pose at a time, or at a value of an input.
struct Pose {
    const kdl::Node* node = nullptr;
    Time time;
    SourceSpan place;
    KeyLaws laws;
    KeyDriver driver;
    std::vector<PosedBone> bones; ///< each at most once
};

/// Reads the poses of one skeleton.
class PoseReader {
public:
    /// `bones` and `context` must outlive the reader.
    PoseReader(const std::vector<Bone>& bones, SceneContext& context) : bones_{bones}, context_{context} {}

    /// `node` must live as long as the poses.
    void read(const kdl::Node& node);
    /// After the last pose: returns those that have a time, with what their names mean.
    std::vector<Pose> take();

private:
    /// A pose that has a name and says what it is.
    struct Definition {
        std::string name;
        SourceSpan place;
        std::vector<PosedBone> bones;
        bool is_used = false;
    };
    /// A pose whose name is to be looked up.
    struct Mention {
        std::size_t pose;
        const kdl::Value* name;
    };

    void read_definition(const kdl::Node& node);
    void read_timed(const kdl::Node& node);
    bool in_order(const Pose& pose);
    void define(const kdl::Value& name, SourceSpan place, const std::vector<PosedBone>& bones, bool is_used);
    std::vector<PosedBone> read_bones(const kdl::Node& node);
    std::optional<PosedBone> read_bone(const kdl::Node& node);
    void look_up(const Mention& mention);
    void set(Pose& pose, std::vector<PosedBone> bones);
    void warn_of_idle_laws();
    void refuse_two_drivers();
    void take_scene_times();

    const std::vector<Bone>& bones_;
    SceneContext& context_;
    NameTable names_;
    std::vector<Definition> definitions_;
    std::vector<Mention> mentions_;
    std::vector<Pose> poses_;
};

/// The schema of poses with a time and without, and of the bones in them.
std::vector<NodeSchema> pose_schema();

}
