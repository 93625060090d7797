#include "host/program/failure.hpp"
#include "tests/host/art/random_document.hpp"
#include "tests/host/scene_text/written.hpp"
#include "tests/rounds.hpp"

#include <array>
#include <string_view>

namespace kfast::test {
namespace {

/// Documents with all that there is to write, in ways that readers may hand over: times anywhere, channels
/// with eases of their own, names of any kind.
class AnyDocument {
public:
    explicit AnyDocument(unsigned seed) : random_{seed} {}

    art::Document make()
    {
        art::Document document;
        document.width = random_.number(1, 2000);
        document.height = random_.number(1, 2000);
        document.frames = random_.number(0.5, 100);
        document.frame_rate = random_.number(1, 120);
        document.loop = static_cast<Loop>(random_.integer(0, 2));
        if (random_.chance(0.3))
            document.camera = random_.number(1, 5000);
        if (random_.chance(0.5))
            document.background = colour();
        for (int i = random_.integer(0, 2); i > 0; --i)
            document.rigs.push_back(rig());
        rigs_ = document.rigs;
        document.nodes = nodes(random_.integer(0, 11));
        for (int i = random_.integer(0, 4); i > 0; --i)
            document.markers.push_back({name(), random_.number(-20, 120), random_.number(-5, 60)});
        return document;
    }

private:
    std::string name()
    {
        static constexpr std::array<std::string_view, 12> names{
            "",     "eye",   "eye",       "Shape Layer 1", "true",   "12",
            "a\nb", "\"x\"", "\xff\x00q", "white",         "points", "rest"};
        return std::string{names[static_cast<std::size_t>(random_.integer(0, 11))]};
    }

    art::Channel channel(double default_value, double reach)
    {
        if (random_.chance(0.5))
            return {random_.chance(0.5) ? default_value : random_.number(-reach, reach)};
        art::Channel channel = random_.channel(-20, 120, reach);
        for (auto& key : channel.keys)
            if (random_.chance(0.2))
                key.ease = {art::EaseKind::cubic, random_.number(0, 1), random_.number(-9, 9),
                            random_.number(0, 1), random_.number(-9, 9)};
        return channel.keys.empty() ? art::Channel{default_value} : channel;
    }

    art::Rgb colour() { return {random_.number(-0.1, 1.1), random_.number(0, 1), random_.number(0, 1)}; }

    art::Animated<art::Rgb> colours()
    {
        if (random_.chance(0.5))
            return {colour()};
        std::vector<art::Key<art::Rgb>> keys;
        for (const double time : random_.times(-10, 110))
            keys.push_back({time, colour(), random_.ease()});
        return keys.empty() ? art::Animated<art::Rgb>{colour()} : art::Animated<art::Rgb>{std::move(keys)};
    }

    scene::Outline outline(int curves)
    {
        scene::Outline outline{random_.spot(100), {}, random_.chance(0.5)};
        for (int i = 0; i < curves; ++i)
            outline.curves.push_back(
                random_.chance(0.5)
                    ? scene::line_to(random_.spot(random_.chance(0.2) ? 0 : 100))
                    : scene::cubic_to(random_.spot(100), random_.spot(100), random_.spot(3000)));
        if (random_.chance(0.3) && curves > 0)
            outline.curves.back().to = outline.from;
        return outline;
    }

    art::Drawing drawing()
    {
        art::Drawing drawing;
        for (int i = random_.integer(0, 3); i > 0; --i)
            drawing.outlines.push_back(outline(random_.integer(0, 4)));
        return drawing;
    }

    art::Shape shape()
    {
        art::Shape shape;
        std::vector<art::Key<art::Drawing>> keys;
        for (const double time : random_.times(-10, 110))
            keys.push_back({time, drawing(), random_.ease()});
        shape.drawing =
            keys.empty() ? art::Animated<art::Drawing>{drawing()} : art::Animated<art::Drawing>{keys};
        if (random_.chance(0.7))
            shape.fill = art::Fill{colours(), channel(1, 1), FillRule::even_odd};
        if (random_.chance(0.6))
            shape.stroke = art::StrokeStyle{colours(),
                                            channel(1, 1),
                                            channel(2, 6),
                                            static_cast<Cap>(random_.integer(0, 2)),
                                            static_cast<Join>(random_.integer(0, 2)),
                                            random_.number(0, 40)};
        shape.matches_length = random_.chance(0.3);
        if (!rigs_.empty() && random_.chance(0.3))
            deform(shape);
        return shape;
    }

    /// Of one form, as what bones carry is.
    void deform(art::Shape& shape)
    {
        const std::size_t rig =
            static_cast<std::size_t>(random_.integer(0, static_cast<int>(rigs_.size()) - 1));
        const int curves = random_.integer(2, 5);
        std::vector<art::Key<art::Drawing>> keys;
        for (double time = 0; time < 50; time += 20) {
            keys.push_back({time, {{outline(curves)}}, random_.ease()});
            keys.back().value.outlines.front().closed = false;
            keys.back().value.outlines.front().curves.back().to = {200, 200};
        }
        shape.drawing = art::Animated<art::Drawing>{std::move(keys)};
        shape.matches_length = false;
        art::Skin skin{rig, {}, random_.chance(0.5)};
        for (int i = 0; i <= curves; ++i) {
            skin.points.emplace_back();
            const auto bones = static_cast<int>(rigs_[rig].bones.size());
            for (int bone = 0; bone < bones && bone < 4; ++bone)
                skin.points.back().push_back({static_cast<std::size_t>(bone), random_.number(0.01, 5)});
        }
        shape.skin = std::move(skin);
    }

    art::Rig rig()
    {
        art::Rig rig{name(), {}};
        for (int i = random_.integer(1, 5); i > 0; --i) {
            art::Bone bone;
            bone.name = name();
            if (!rig.bones.empty() && random_.chance(0.7))
                bone.parent =
                    static_cast<std::size_t>(random_.integer(0, static_cast<int>(rig.bones.size()) - 1));
            bone.from = bone.parent && random_.chance(0.5) ? rig.bones[*bone.parent].to : random_.spot(200);
            bone.to = bone.from + scene::Vec2{random_.number(5, 50), random_.number(-50, 50)};
            bone.rotation = channel(0, 400);
            bone.x = channel(0, 50);
            bone.y = channel(0, 50);
            if (random_.chance(0.3))
                bone.length = art::Channel{channel(0, 50)};
            bone.at_tip = random_.chance(0.5);
            rig.bones.push_back(std::move(bone));
        }
        return rig;
    }

    art::Transform transform()
    {
        art::Transform transform;
        transform.x = channel(0, 300);
        transform.y = channel(0, 300);
        transform.anchor_x = channel(0, 50);
        transform.anchor_y = channel(0, 50);
        transform.rotate = channel(0, 700);
        transform.scale_x = channel(1, 3);
        transform.scale_y = channel(1, 3);
        if (random_.chance(0.1))
            transform.skew = channel(0, 80);
        if (random_.chance(0.1)) {
            transform.rotate_x = channel(0, 90);
            transform.rotate_y = channel(0, 90);
            transform.z = channel(0, 100);
        }
        if (random_.chance(0.1))
            transform.path =
                art::MotionPath{{{{random_.spot(100), {scene::line_to(random_.spot(300))}, false}}},
                                channel(0, 1),
                                random_.chance(0.5)};
        return transform;
    }

    std::vector<art::Node> nodes(int depth)
    {
        std::vector<art::Node> nodes;
        for (int i = random_.integer(1, depth > 3 ? 1 : 2); i > 0; --i)
            nodes.push_back(node(depth));
        return nodes;
    }

    art::Node node(int depth)
    {
        art::Node node;
        node.name = name();
        if (random_.chance(0.5))
            node.transform = transform();
        node.opacity = random_.chance(0.7) ? art::Channel{1} : channel(1, 1);
        if (random_.chance(0.2))
            node.shown = {{random_.number(-20, 20), random_.number(20, 50)}, {random_.number(51, 60), 80}};
        node.parent_tag = static_cast<std::size_t>(random_.integer(0, 2));
        if (depth > 0)
            node.content = art::Group{nodes(depth - 1)};
        else
            node.content = shape();
        return node;
    }

    RandomArt random_;
    std::vector<art::Rig> rigs_ = {};
};

}

TEST_CASE("any document gives a text without errors and warnings")
{
    for (unsigned seed = 0; seed < static_cast<unsigned>(rounds(200)); ++seed) {
        INFO("seed ", seed);
        art::Losses losses;
        written(AnyDocument{seed}.make(), losses);
    }
}

}
