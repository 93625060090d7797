#include "core/pose/scene_state.hpp"

#include "core/bytes/bump_allocator.hpp"
#include "core/bytes/expects.hpp"
#include "core/features.hpp"

#include <algorithm>
#include <utility>

namespace kfast {

namespace {

Space canvas_space(Size canvas, Size panel, Fit fit)
{
    const Affine map = canvas_map(canvas, panel, fit);
    return {.plane = map, .zz = map.xx};
}

Camera camera_for(const SceneView& scene, Size panel, const Space& canvas)
{
    return {.x = std::int64_t{panel.width} * Fixed::one / 2,
            .y = std::int64_t{panel.height} * Fixed::one / 2,
            .distance = std::int64_t{scene.camera()} * canvas.zz};
}

}

SceneOnPanel on_panel(const SceneView& scene, Size panel, Fit fit)
{
    const Space canvas = canvas_space(scene.canvas(), panel, fit);
    return {.scene = scene,
            .canvas = canvas,
            .camera = camera_for(scene, panel, canvas),
            .rigid = RigidPlacements{canvas.plane.xx}};
}

LabelTrace label_of(const SceneOnPanel& on_panel, const LiveView& live)
{
    const SceneView& scene = on_panel.scene;
    const LabelView label = LabelView::of(live.label);
    if (!label.shows_number)
        return {label, on_panel.texts.glyphs(scene, live.input), scene.drawings()};
    const Time place = live.input < on_panel.inputs.size() ? on_panel.inputs[live.input] : Time{};
    return {label, scene.input(live.input), place, scene.drawings()};
}

namespace {

std::size_t posed_bone_bytes(const SceneView& scene) { return scene.bone_count() * sizeof(PosedBone); }
std::size_t backbone_node_bytes(const SceneView& scene)
{
    return scene.backbone_nodes() * sizeof(BackboneNode);
}
/// Includes what may be skipped to align them.
std::size_t space_bytes(const SceneView& scene)
{
    const std::size_t bytes = scene.records().spaces * sizeof(Space);
    return bytes == 0 ? 0 : bytes + alignof(Space) - 4;
}
std::span<Space> spaces_in(std::span<std::byte> memory)
{
    if (memory.empty())
        return {};
    const std::size_t gap = -reinterpret_cast<std::uintptr_t>(memory.data()) % alignof(Space);
    const std::span<std::byte> aligned = memory.subspan(gap);
    return {reinterpret_cast<Space*>(aligned.data()), aligned.size() / sizeof(Space)};
}
std::size_t input_bytes(const SceneView& scene) { return scene.input_count() * sizeof(Time); }

static_assert(alignof(PosedBone) <= 4 && alignof(BackboneNode) <= 4);

}

[[gnu::cold]] std::size_t SceneState::bytes_for(const SceneView& scene)
{
    return PreparedScene::bytes_for(scene) + space_bytes(scene) + posed_bone_bytes(scene) +
           backbone_node_bytes(scene) + input_bytes(scene) + InputDrawings::bytes_for(scene) +
           InputTexts::bytes_for(scene);
}

[[gnu::cold]] SceneState::SceneState(const SceneView& scene, Size panel, Fit fit, std::span<std::byte> memory)
    : on_panel_{kfast::on_panel(scene, panel, fit)}
{
    BumpAllocator cutter{memory};
    on_panel_.prepared = PreparedScene{scene, cutter.cut(PreparedScene::bytes_for(scene))};
    on_panel_.spaces = spaces_in(cutter.cut(space_bytes(scene)));
    on_panel_.bones = cutter.cut_as<PosedBone>(posed_bone_bytes(scene));
    on_panel_.backbone_nodes = cutter.cut_as<BackboneNode>(backbone_node_bytes(scene));
    inputs_ = cutter.cut_as<Time>(input_bytes(scene));
    put_default_places(scene.inputs(), inputs_);
    on_panel_.inputs = inputs_;
    on_panel_.drawings = {scene, cutter.cut(InputDrawings::bytes_for(scene))};
    on_panel_.texts = {scene,
                       cutter.cut(InputTexts::bytes_for(scene))}; // last, for it has any number of bytes
    if (!on_panel_.bones.empty())
        scene.features().bones->set_up(scene, on_panel_.prepared, on_panel_.bones);
}

const Dependence& SceneState::move_to(Time time)
{
    on_panel_.prepared.move_to(scene(), {time, inputs_}, std::exchange(changed_inputs_, 0));
    return on_panel_.prepared.moved();
}

void SceneState::pose_bones()
{
    if (!on_panel_.bones.empty())
        scene().features().bones->pose(scene(), on_panel_.prepared, on_panel_.bones);
}

SceneTime SceneState::pose(Time time)
{
    move_to(time);
    pose_bones();
    return {time, inputs_, on_panel_.prepared.clocks()};
}

void SceneState::set_input(std::uint32_t number, Time place)
{
    expects(number < inputs_.size());
    const Time held = std::clamp(place, Time{}, whole_input);
    if (std::exchange(inputs_[number], held) != held)
        mark_input_changed(number); // labels may show it
}

void SceneState::set_text(std::uint32_t number, std::string_view text)
{
    if (on_panel_.texts.put(scene(), number, text))
        mark_input_changed(number);
}

bool SceneState::set_drawing(std::uint32_t number, std::span<const InputStroke> strokes)
{
    InputDrawing live = drawing(number);
    live.begin();
    for (const InputStroke& stroke : strokes) {
        live.begin_stroke();
        if (!std::ranges::all_of(stroke, [&live](InputPoint point) { return live.add(point); })) {
            live.begin();
            return false;
        }
    }
    show_next_drawing(number);
    return true;
}

void SceneState::show_next_drawing(std::uint32_t number)
{
    if (drawing(number).show())
        mark_input_changed(number);
}

void SceneState::mark_input_changed(std::uint32_t number) { changed_inputs_ |= bit_of_input(number); }

}
