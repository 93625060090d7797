#include "host/compiler/limits/outline_meter.hpp"

#include "core/player.hpp"
#include "core/scene/kfb_limits.hpp"

#include <algorithm>
#include <utility>

namespace kfast {
namespace {

constexpr int band_bits = 0;

Size panel_for(Size canvas) { return {canvas.width, std::min(3 * canvas.height, Player::max_panel)}; }

}

OutlineMeter::OutlineMeter(const SceneView& scene, std::size_t bytes)
    : outlines_(bytes / 4), cache_(kfb::max_cache_bytes / 4),
      heads_(static_cast<std::size_t>(panel_for(scene.canvas()).height)), steps_(scene.paint_steps()),
      prepared_(PreparedScene::bytes_for(scene) / 4), spaces_(scene.records().spaces),
      bones_(scene.bone_count()), backbone_nodes_(scene.backbone_nodes()),
      drawings_(InputDrawings::bytes_for(scene) / 4),
      texts_(InputTexts::bytes_for(scene)), on_panel_{on_panel(scene, panel_for(scene.canvas()), Fit::none)}
{
    on_panel_.prepared = PreparedScene{scene, std::as_writable_bytes(std::span{prepared_})};
    on_panel_.spaces = spaces_;
    on_panel_.bones = bones_;
    on_panel_.backbone_nodes = backbone_nodes_;
    on_panel_.drawings = {scene, std::as_writable_bytes(std::span{drawings_})};
    on_panel_.texts = {scene, texts_};
    picture_.outlines = raster::OutlineStore{std::as_writable_bytes(std::span{outlines_}), heads_,
                                             panel_for(scene.canvas()), band_bits};
    picture_.cache = PictureCache{std::as_writable_bytes(std::span{cache_})};
    picture_.storage = steps_;
    set_up_bones(scene, on_panel_.prepared, bones_);
    std::uint32_t input = 0;
    for (InputCursor inputs = scene.inputs(); !inputs.at_end(); ++input)
        if (inputs.next().type == InputType::drawing)
            on_panel_.drawings.of(scene, input).show(); // the next one, which is empty
    on_panel_.prepared.move_to(scene, {}, 0);
    trace();
}

void OutlineMeter::put_text(std::uint32_t number, std::string_view text)
{
    if (on_panel_.texts.put(on_panel_.scene, number, text))
        changed_inputs_ |= bit_of_input(number);
}

const raster::Picture& OutlineMeter::picture_at(const SceneTime& moment)
{
    on_panel_.prepared.move_to(on_panel_.scene, moment, std::exchange(changed_inputs_, 0));
    if (picture_.dependence.is_touched_by(on_panel_.prepared.moved()))
        trace();
    return picture_;
}

std::size_t OutlineMeter::live_bytes() const { return drawings_.empty() ? 0 : live_outline_bytes(on_panel_); }

void OutlineMeter::trace()
{
    pose_bones(on_panel_.scene, on_panel_.prepared, bones_);
    Tracer{on_panel_, picture_}.run();
}

}
