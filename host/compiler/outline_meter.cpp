#include "host/compiler/outline_meter.hpp"

#include <utility>

namespace kfast {
namespace {

/// Opposite to the middle of the canvas.
Camera camera_of(const SceneView& scene)
{
    const Size canvas = scene.canvas();
    return {.x = std::int64_t{canvas.width} * Fixed::one / 2,
            .y = std::int64_t{canvas.height} * Fixed::one / 2,
            .distance = std::int64_t{scene.camera()} * Fixed::one};
}

}

OutlineMeter::OutlineMeter(const SceneView& scene, std::size_t bytes)
    : outlines_(bytes / 4), steps_(scene.paint_steps()), bones_(scene.bone_count()),
      backbone_nodes_(scene.backbone_nodes()), inputs_(scene.input_count()),
      drawings_(LiveDrawings::bytes_for(scene) / 4),
      texts_(LiveTexts::bytes_for(scene)), on_panel_{scene,
                                                     {},
                                                     camera_of(scene),
                                                     bones_,
                                                     backbone_nodes_,
                                                     {scene, std::as_writable_bytes(std::span{drawings_})},
                                                     {scene, texts_}}
{
    picture_.outlines = OutlineStore{std::as_writable_bytes(std::span{outlines_}), OutlineStore::every_row};
    picture_.storage = steps_;
    set_up_bones(scene, bones_);
    std::uint32_t input = 0;
    for (InputCursor inputs = scene.inputs(); !inputs.at_end(); ++input)
        if (inputs.next().type == InputType::drawing)
            on_panel_.drawings.of(scene, input).show(); // the next one, which is empty
    trace(Time{});
}

void OutlineMeter::put_text(std::uint32_t number, std::string_view text)
{
    if (on_panel_.texts.put(on_panel_.scene, number, text))
        told_ |= bit_of_input(number);
}

const TracedPicture& OutlineMeter::picture_at(const Moment& moment)
{
    const std::uint32_t moved = take_inputs(moment) | std::exchange(told_, 0);
    if (!picture_.still.holds(moment.time(), moved))
        trace(moment);
    return picture_;
}

OutlineAmount OutlineMeter::live_outlines_at(const Moment& moment) const
{
    return drawings_.empty() ? OutlineAmount{} : live_outlines(on_panel_, moment);
}

/// A bit for each input that stands elsewhere than in the picture before.
std::uint32_t OutlineMeter::take_inputs(const Moment& moment)
{
    std::uint32_t moved = 0;
    for (std::uint32_t input = 0; input < inputs_.size(); ++input) {
        const Time place = moment.at({static_cast<std::uint8_t>(input + 1)});
        if (std::exchange(inputs_[input], place) != place)
            moved |= bit_of_input(input);
    }
    return moved;
}

void OutlineMeter::trace(const Moment& moment)
{
    pose_bones(on_panel_.scene, moment, bones_);
    Tracer{on_panel_, moment, picture_, nullptr, 0}.run();
}

}
