// seed_kinds FILE|FOLDER...: what of docs/format.md occurs in compiled scenes, a line for each: its section
// and what it is. What never occurs is told after them, and the status is 1. Of a drawing its first stroke is
// looked at.
#include "core/scene/format.hpp"
#include "core/scene/input_view.hpp"
#include "core/scene/scene_view.hpp"
#include "core/time/spring_law.hpp"
#include "host/walk/every_item.hpp"
#include "tests/fuzz/kinds.hpp"
#include "tests/fuzz/seed_files.hpp"

#include <cstdint>
#include <string>
#include <vector>

using namespace kfast;
using test::Census;

namespace {

/// Goes through one scene.
class Look {
public:
    Look(const SceneView& scene, Census& census) : scene_{scene}, census_{census} {}

    void at_all()
    {
        at_header();
        at_inputs();
        at_marks();
        at_bones();
        for (std::uint32_t symbol = 0; symbol < scene_.symbol_count(); ++symbol)
            see("Symbols: symbol", 0);
        every_item(scene_, [this](const ItemView& item) { at_item(item); });
    }

private:
    template <class Variant>
    void see(const std::string& kind, Variant variant)
    {
        census_.see(kind, static_cast<std::size_t>(variant));
    }

    void at_header()
    {
        see("Header: end", scene_.loop());
        see("Header: camera", scene_.camera() != default_camera(scene_.canvas()));
        see("Header: rate", scene_.frame_rate() % 1000 != 0);
        for (std::size_t index = 0; index < scene_.palette_size(); ++index)
            see("Palette: opacity", scene_.colour(index).opacity != 255);
    }

    void at_laws(std::uint32_t number)
    {
        const LawPair laws = scene_.laws(number);
        see("Laws: law", laws.x.kind);
        see("Laws: law", laws.y.kind);
        for (const VelocityLaw& law : {laws.x, laws.y})
            if (is_spring(law))
                see("Laws: springs at", end_of(law));
        see("Laws: law for y", laws.y != laws.x);
    }

    void at_inputs()
    {
        for (InputCursor inputs = scene_.inputs(); !inputs.at_end();) {
            const InputView input = inputs.next();
            see("Inputs: kind", input.type);
            if (input.type == InputType::number)
                see("Numbers: usual value", input.default_value == input.min   ? 0
                                            : input.default_value == input.max ? 2
                                                                               : 1);
            if (input.type == InputType::text)
                at_text(input.text);
            if (input.type == InputType::drawing) {
                see("Drawings from outside: usual drawing",
                    scene_.drawing(input.drawing.default_value).strokes() != 0);
                at_drawing(input.drawing.default_value);
            }
        }
    }

    void at_text(const TextInput& text)
    {
        const std::uint32_t last = text.glyphs.count() - 1;
        see("Texts: stretches", text.glyphs.character(last) - text.glyphs.character(0) != last);
        see("Texts: usual text", !text.default_value.empty());
    }

    void at_marks()
    {
        for (ClockCursor clocks = scene_.clocks(); !clocks.at_end();)
            at_clock(clocks.next());
        for (ClipCursor clips = scene_.clips(); !clips.at_end();)
            see("Marks: clip", clips.next().loop);
        for (EventCursor events = scene_.events(); !events.at_end(); events.next())
            see("Marks: event", 0);
    }

    void at_clock(const Clock& clock)
    {
        see("Clocks: reads", clock.driver.is_clock());
        see("Clocks: at its end", clock.loop);
        see("Clocks: length", clock.length != Time{});
        see("Clocks: speed", clock.speed < 0);
    }

    void at_key_times(KeyTimeCursor key_times)
    {
        if (key_times.count() == 0)
            return;
        const Driver driver = key_times.driver();
        see("Key times: go by", driver.is_time() ? 0 : driver.is_input() ? 1 : 2);
        see("Key times: number", key_times.count() > 1);
        while (!key_times.at_end())
            at_laws(key_times.next().laws);
    }

    void at_bones()
    {
        for (SkeletonCursor skeletons = scene_.skeletons(); !skeletons.at_end();) {
            const SkeletonView skeleton = skeletons.next();
            see("Bones: common key times", skeleton.common_key_times().count() != 0);
            at_key_times(skeleton.common_key_times());
            for (BoneCursor bones = skeleton.bones(); !bones.at_end();)
                at_bone(bones.next());
        }
    }

    void at_bone(const BoneView& bone)
    {
        see("Bones: parent", bone.parent != 0);
        see("Bones: moves with tip", bone.is_at_tip);
        see("Bones: turns as written", bone.turns_as_written);
        for (std::size_t quantity = 0; quantity < bone_quantity_count; ++quantity) {
            if (bone.keys[quantity].kind() == BoneKeys::Kind::none)
                continue;
            see("Bones: keys of", quantity);
            if (bone.keys[quantity].kind() == BoneKeys::Kind::own)
                at_key_times(bone.keys[quantity].keys().key_times());
        }
    }

    void at_item(const ItemView& item)
    {
        see("Items: kind", item.object.has_depths ? ItemKind::object : item.kind);
        at_tracks(item);
        if (!item.is_leaf())
            return;
        at_style(item.object.style);
        see("Tracks: beam style", item.beam.parts);
        if (item.kind == ItemKind::live)
            at_live(item.live);
        else
            at_object(item.object);
    }

    /// The mode of a trim has no keys.
    void at_cut(const TrackView& track)
    {
        const int number = static_cast<int>(track.property) - static_cast<int>(Property::trim_from);
        if (track.is_fixed)
            see("Tracks: fixed cut", number);
        else
            see("Tracks: keys of cut", track.property > Property::trim_mode ? number - 1 : number);
    }

    void at_tracks(const ItemView& item)
    {
        for (TrackCursor tracks = item.tracks; !tracks.at_end();) {
            const TrackView track = tracks.next();
            if (cuts_strokes(track.property))
                at_cut(track);
            else
                see(track.is_fixed ? "Tracks: fixed" : "Tracks: keys of", track.property);
            if (track.property == Property::along) {
                see("Tracks: path turns", item.path.turns);
                at_drawing(item.path.drawing);
            }
            if (track.is_fixed)
                continue;
            see("Tracks: smooth", track.is_smooth);
            at_key_times(track.keys.key_times());
        }
    }

    void at_style(const ObjectStyle& style)
    {
        see("Items: filled", style.is_filled);
        see("Items: stroked", style.is_stroked);
        see("Items: rule", style.fill_rule);
        if (!style.is_stroked)
            return;
        see("Items: cap", style.cap);
        see("Items: join", style.join);
    }

    void at_live(const LiveView& live)
    {
        see("Live items: shows", live.kind);
        if (live.kind != InputLeaf::label)
            return;
        const LabelView label = LabelView::of(live.label);
        see("Live items: place", label.align);
        see("Live items: kerned", label.pair_count() != 0);
        see("Live items: number", label.shows_number);
        if (label.shows_number)
            at_format(label.format);
        see("Live items: spacing", label.spacing != 0);
        for (std::uint32_t glyph = 0; glyph < label.glyph_count; ++glyph)
            at_drawing(static_cast<std::uint32_t>(label.drawings[glyph]));
    }

    void at_format(const NumberFormat& format)
    {
        see("Live items: decimals", format.decimals != 0);
        see("Live items: gaps", format.places != 0);
        see("Live items: around a number", !format.before.empty() || !format.behind.empty());
    }

    void at_object(const ObjectView& object)
    {
        see("Items: arrival drawings", object.has_arrivals);
        see("Items: carried by", object.deformer);
        see("Wire frames: depths", object.has_depths);
        at_key_times(object.keys().key_times());
        for (KeyCursor keys = object.keys(); !keys.at_end();) {
            const Key key = keys.next();
            at_drawing(key.drawing);
            if (object.has_arrivals)
                at_drawing(key.arrival);
            if (object.has_depths)
                at_drawing(static_cast<std::uint32_t>(key.more));
            if (object.deformer == Deformer::bones)
                at_skin(key);
        }
        if (object.deformer == Deformer::backbones)
            at_backbones(object.backbones);
    }

    void at_skin(const Key& key)
    {
        see("Skins: is", key.more < 0);
        if (key.more < 0)
            return;
        SkinReader skin = scene_.skin(key.more);
        see("Skins: drawing at rest", skin.has_drawing_at_rest());
        PackedDrawing drawing = scene_.drawing(key.drawing);
        for (std::uint32_t stroke = 0; stroke < drawing.strokes(); ++stroke) {
            const std::uint32_t segments = drawing.next_stroke();
            for (std::uint32_t i = 0; i <= segments; ++i) {
                see("Skins: fine weights", has_fine_weights(skin.next()));
                if (i != segments)
                    drawing.next_segment();
            }
        }
    }

    static bool has_fine_weights(const Binding& binding)
    {
        bool is_fine = false;
        binding.each([&is_fine](BoneInfluence share) {
            is_fine = is_fine || share.weight % kfb::skin::coarse_weight != 0;
        });
        return is_fine;
    }

    void at_backbones(const BackbonesView& backbones)
    {
        for (BackboneKeyCursor keys = backbones.keys(); !keys.at_end();) {
            const BackboneKey key = keys.next();
            see("Backbones: number", scene_.drawing(key.drawing).strokes() > 3);
            at_drawing(key.drawing);
        }
    }

    void at_drawing(std::uint32_t offset)
    {
        ByteReader bytes{scene_.drawings().subspan(offset)};
        const std::uint32_t strokes = bytes.varint();
        see("Drawings: strokes", strokes > 1 ? 2 : strokes);
        if (strokes == 0)
            return;
        bytes.signed_varint();
        bytes.signed_varint();
        const std::uint32_t head = bytes.u8();
        if (kfb::repeated_form::mix.get(head) != static_cast<std::uint32_t>(SegmentMix::repeat))
            return at_form(head, bytes);
        see("Forms: segments", SegmentMix::repeat);
        see("Drawings: mirrored",
            kfb::repeated_form::mirrors_x.get(head) + 2 * kfb::repeated_form::mirrors_y.get(head));
    }

    /// `bytes` go on behind the first byte of the form.
    void at_form(std::uint32_t head, ByteReader bytes)
    {
        const StrokeForm form = StrokeForm::unpacked(head | bytes.u8() << 8);
        see("Forms: segments", form.mix);
        see("Forms: end", form.end);
        see("Forms: sparse ends", form.ends.is_sparse);
        see("Forms: sparse control points", form.controls.is_sparse);
        see("Forms: smoothness", form.smooth);
        see("Forms: predicted", kfb::segments::are_predicted.get(bytes.varint()));
    }

    const SceneView& scene_;
    Census& census_;
};

}

int main(int count, char** words)
{
    const std::vector<std::string> places(words + 1, words + count);
    Census census;
    for (const auto& seed : test::read_scenes(places))
        if (const auto scene = SceneView::parse(seed))
            Look{*scene, census}.at_all();
    return census.print() ? 0 : 1;
}
