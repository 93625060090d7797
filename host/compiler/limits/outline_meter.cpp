#include "host/compiler/limits/outline_meter.hpp"

#include "core/math/affine.hpp"
#include "core/player.hpp"
#include "core/scene/kfb_limits.hpp"
#include "core/scene_walk.hpp"
#include "host/walk/input_text.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>

namespace kfast {

namespace {

constexpr std::size_t corner_bytes =
    sizeof(raster::Corner) + sizeof(raster::Bend); ///< bytes, while it is added
constexpr std::size_t chain_bytes = sizeof(raster::Chain) + sizeof(raster::Bend) + 8;

/// Bytes of an edge over that many rows. A long one is a chain of its own, and may cut off another one
/// (core/raster/outline/outline_store.hpp).
std::size_t max_edge_bytes(std::size_t rows)
{
    constexpr std::size_t line_bytes = sizeof(raster::Chain) + sizeof(raster::StraightLine);
    return std::min(chain_bytes + rows * sizeof(raster::Crossing), line_bytes + chain_bytes);
}

/// Not all edges of a drawing are as bad as they can be: the worst that were tried take more than two thirds.
std::size_t likely(std::size_t bytes) { return bytes * 4 / 5; }

/// What `strokes` with `points` in all take at most when they are filled: each corner of a polygon is stored,
/// the first one twice.
std::size_t max_filled_bytes(std::size_t strokes, std::size_t points, std::size_t rows)
{
    return (points + strokes) * corner_bytes + points * max_edge_bytes(rows);
}

/// The same when a pen follows them.
///
/// A join has 3 corners on its inner and 2 on its outer side, and those of a round between them. Besides two
/// edges along its pieces it has others around it, which reach no further than the pen, and are a chain if
/// they turn.
std::size_t max_drawn_bytes(std::size_t strokes, std::size_t points, const Pen& pen, std::size_t rows)
{
    const auto round = static_cast<std::size_t>(max_corners_of_half_turn(pen.half_width));
    const std::size_t of_join = 5 + (pen.join == Join::round ? round : 0);
    const std::size_t of_cap = pen.cap == Cap::round ? round : pen.cap == Cap::square ? 2 : 0;
    const std::size_t of_ends = 5 + (pen.cap == Cap::butt ? 0 : 2 * of_cap + 3);
    const std::size_t joins = points - strokes; // one more than an open stroke has: it may be closed
    const std::size_t pen_rows =
        std::min(rows, static_cast<std::size_t>((pen.half_width + pen.half_width).raw() >> 16) + 2);
    const std::size_t of_turn = chain_bytes + 2 * pen_rows * sizeof(raster::Crossing);
    return (strokes * of_ends + joins * of_join) * corner_bytes + points * 2 * max_edge_bytes(rows) +
           (joins + 4 * strokes) * of_turn;
}

/// Fewer strokes have more joins.
std::size_t max_drawn_bytes(const DrawingInput& limits, const Pen& pen, std::size_t rows)
{
    return std::max(max_drawn_bytes(limits.strokes, limits.points, pen, rows),
                    max_drawn_bytes(1, limits.points, pen, rows));
}

/// The scale of lengths around any point of a drawing, at most; in perspective by the maximum over 17 x 17 of
/// the positions that a point can have.
std::int32_t max_scale_factor(const Space& space, const Camera& camera)
{
    if (space.is_flat())
        return space.plane.scale_factor();
    constexpr int farthest = 2048; // px
    constexpr int step = farthest / 8;
    const Projection projection{space, camera};
    std::int32_t max = 0;
    for (int x = -farthest; x <= farthest; x += step)
        for (int y = -farthest; y <= farthest; y += step)
            max = std::max(max, projection.scale_factor_at({Fixed::pixels(x), Fixed::pixels(y)}));
    return max;
}

/// What a drawing from outside takes.
std::size_t bytes_of(const SceneOnPanel& on_panel, SceneWalk& walk)
{
    const DrawingInput limits = on_panel.scene.input(walk.node().of).drawing;
    const ObjectStyle& style = walk.node().style;
    const auto rows = static_cast<std::size_t>(on_panel.scene.canvas().height);
    std::size_t bytes = 0;
    if (style.is_filled)
        bytes += likely(max_filled_bytes(limits.strokes, limits.points, rows));
    if (style.is_stroked)
        bytes += likely(max_drawn_bytes(
            limits,
            {.half_width = half_width(walk.state().width(), max_scale_factor(walk.space(), on_panel.camera)),
             .cap = style.cap,
             .join = style.join},
            rows));
    return bytes;
}

}

std::size_t live_outline_bytes(const SceneOnPanel& on_panel)
{
    std::size_t bytes = 0;
    SceneWalk walk{on_panel, SceneWalk::Opacity::of_leaves};
    while (walk.next() == SceneWalk::Step::leaf)
        if (walk.node().kind == ItemKind::live && walk.node().live == InputLeaf::drawing)
            bytes += bytes_of(on_panel, walk);
    return bytes;
}

namespace {

constexpr int band_bits = 0;

Size panel_for(Size canvas) { return {canvas.width, std::min(3 * canvas.height, Player::max_panel)}; }

}

OutlineMeter::OutlineMeter(const SceneView& scene, std::size_t bytes)
    : outlines_(bytes / 4),
      cache_(kfb::max_cache_bytes / 4),
      heads_(static_cast<std::size_t>(panel_for(scene.canvas()).height)),
      steps_(scene.paint_steps()),
      prepared_(PreparedScene::bytes_for(scene) / 4),
      spaces_(scene.records().spaces),
      bones_(scene.bone_count()),
      backbone_nodes_(scene.backbone_nodes()),
      drawings_(InputDrawings::bytes_for(scene) / 4),
      texts_(InputTexts::bytes_for(scene)),
      on_panel_{on_panel(scene, panel_for(scene.canvas()), Fit::none)}
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
    if (!std::ranges::equal(inputs_, moment.inputs()))
        changed_inputs_ |= on_panel_.scene.number_inputs();
    inputs_.assign(moment.inputs().begin(), moment.inputs().end());
    on_panel_.inputs = inputs_;
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

std::size_t peak_bytes(std::span<const MeasuredMoment> moments, OutlineMeter& meter)
{
    constexpr std::size_t samples = 8;
    std::size_t bytes = 0;
    for (std::size_t i = 0; i < samples; ++i) {
        const MeasuredMoment& sample = moments[i * moments.size() / samples];
        bytes = std::max(bytes, meter.picture_at(sample.moment()).outlines.needed_bytes());
    }
    return bytes;
}

namespace {

constexpr std::size_t max_samples = 24;

std::size_t glyph_count(const SceneView& scene)
{
    std::size_t count = 0;
    for (InputCursor inputs = scene.inputs(); !inputs.at_end();)
        if (const InputView input = inputs.next(); input.type == InputType::text)
            count += input.text.glyphs.count();
    return count;
}

/// Samples, in each of which all glyphs are measured.
std::vector<MeasuredMoment> samples_of(const SceneView& scene, std::span<const MeasuredMoment> moments,
                                       OutlineMeter& meter)
{
    const std::size_t pictures = affordable_pictures(scene, peak_bytes(moments, meter));
    const std::size_t affordable =
        std::max<std::size_t>(pictures / std::max<std::size_t>(glyph_count(scene), 1), 1);
    const std::size_t count = std::min({moments.size(), max_samples, affordable});
    std::vector<MeasuredMoment> samples;
    for (std::size_t i = 0; i < count; ++i)
        samples.push_back(moments[i * moments.size() / count]);
    return samples;
}

/// The character that needs most at one time.
struct Largest {
    std::uint32_t glyph = 0;
    std::size_t max = 0;
    std::size_t min = 0; ///< of any character

    /// Otherwise the text is not visible.
    bool is_visible() const { return max != min; }
};

/// The characters that need most at some of the samples, and the one that has most points: the text may be
/// visible at other times.
std::set<std::uint32_t> largest_glyphs(const SceneView& scene, std::uint32_t number, const TextInput& input,
                                       const std::vector<MeasuredMoment>& samples, OutlineMeter& meter)
{
    std::vector<Largest> largest(samples.size());
    for (std::uint32_t glyph = 0; glyph < input.glyphs.count(); ++glyph) {
        meter.put_text(number, full_text(input, glyph));
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const std::size_t bytes = meter.picture_at(samples[i].moment()).outlines.needed_bytes();
            Largest& at = largest[i];
            at.min = glyph == 0 ? bytes : std::min(at.min, bytes);
            if (glyph == 0 || bytes > at.max)
                at = {glyph, bytes, at.min};
        }
    }
    const std::vector<std::size_t> points = glyph_points(scene, number, input);
    std::set glyphs{static_cast<std::uint32_t>(std::ranges::max_element(points) - points.begin())};
    for (const Largest& at : largest)
        if (at.is_visible())
            glyphs.insert(at.glyph);
    return glyphs;
}

}

void put_texts(const LargestTexts& texts, OutlineMeter& meter)
{
    for (std::uint32_t number = 0; number < texts.size(); ++number)
        meter.put_text(number, texts[number]);
}

std::vector<LargestTexts> largest_texts(const SceneView& scene, std::span<const MeasuredMoment> moments,
                                        OutlineMeter& meter)
{
    const std::vector<MeasuredMoment> samples = samples_of(scene, moments, meter);
    std::vector<LargestTexts> sets{LargestTexts(scene.input_count())};
    InputCursor inputs = scene.inputs();
    for (std::uint32_t number = 0; !inputs.at_end(); ++number) {
        const InputView input = inputs.next();
        if (input.type != InputType::text)
            continue;
        const auto glyphs = largest_glyphs(scene, number, input.text, samples, meter);
        if (glyphs.size() > sets.size())
            sets.resize(glyphs.size(), sets.back());
        auto glyph = glyphs.begin();
        for (LargestTexts& texts : sets) {
            texts[number] = full_text(input.text, *glyph);
            if (std::next(glyph) != glyphs.end())
                ++glyph;
        }
    }
    return sets;
}

}
