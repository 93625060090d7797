#include "host/fit/fit_report.hpp"

#include "host/compiler/write/header.hpp"
#include "host/fit/scene_run.hpp"
#include "host/fit/wording.hpp"
#include "tests/compiled.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

namespace kfast::fit {
namespace {

Target desk()
{
    Target target;
    target.name = "desk";
    target.clock = 100e6;
    target.flash = 1 << 20;
    target.ram = 1 << 20;
    target.bus.clock = 60e6;
    target.display.size = {60, 40};
    return target;
}

FitReport report_of(const std::vector<std::byte>& bytes, const Target& target = desk())
{
    const SceneView scene = *SceneView::parse(bytes);
    return fit_report({.scene = scene, .item_names = {}, .target = target});
}

}

TEST_CASE("a picture whose outlines find no room does not fit")
{
    auto bytes = test::compiled("kfast 1\ncanvas 60 40 frames=30\nobject still fill=red { rect 0 0 9 9 }\n"
                                "object comb fill=red {\n"
                                "    path \"M 0 0 L 1 9 L 2 0 L 3 9 L 4 0 L 5 9 L 6 0 L 7 9 L 8 0 L 9 9 Z\"\n"
                                "    key 0 visible=#false; key 20 visible=#true; key 21 visible=#false }\n");
    CHECK(report_of(bytes).fits());
    set_outline_needs(bytes, {.bytes = 260, .borders = 200});
    const FitReport report = report_of(bytes);
    REQUIRE(report.shortages.size() == 1);
    CAPTURE(report.shortages.front());
    CHECK(report.shortages.front().find("outlines: those of frame 20 find no room") == 0);
    CHECK(report.slowness.empty());
    CHECK(report.reasons() == report.shortages);
    CHECK(report.speed.overfull->moment == Time::frame(20));
}

TEST_CASE("a picture that outlasts the watchdog does not fit, even if all others are fast")
{
    const auto bytes =
        test::compiled("kfast 1\ncanvas 60 40 fps=1 frames=30\n"
                       "object still fill=red { rect 0 0 9 9 }\n"
                       "object large fill=red { circle 30 20 r=20\n"
                       "    key 0 visible=#false; key 20 visible=#true; key 21 visible=#false }\n");
    Target target = desk();
    const FitReport fast = report_of(bytes, target);
    CHECK(fast.fits());
    const FrameCost& dearest = *std::ranges::max_element(fast.speed.frames, {}, &FrameCost::cpu_seconds);
    CHECK(dearest.moment >= Time::frame(20));
    const double worst = dearest.cpu_seconds;
    target.watchdog = worst * 1.01;
    CHECK(report_of(bytes, target).fits());
    target.watchdog = worst * 0.99;
    const FitReport report = report_of(bytes, target);
    CHECK_FALSE(report.fits());
    CHECK(report.hang.find("watchdog: frame " + frame_text(dearest.moment) + " takes ") == 0);
    CHECK(report.reasons() == std::vector{report.hang});
}

TEST_CASE("the end of a scene that plays once is looked at")
{
    for (const std::string loop : {"once", "repeat"}) {
        const auto bytes = test::compiled("kfast 1\ncanvas 60 40 frames=10 loop=" + loop +
                                          "\nobject a fill=red { key 0 law=hold { rect 0 0 2 2 }\n"
                                          "    key 10 { rect 0 0 60 40 } }\n");
        const FitReport report = report_of(bytes);
        CHECK(report.speed.frames.size() == (loop == "once" ? 21 : 20));
        CHECK((report.speed.worst().moment == Time::frame(10)) == (loop == "once"));
    }
}

TEST_CASE("a scene is looked at with its inputs moving, too")
{
    for (const std::string bound : {" visible=#false", " input=knob"}) {
        const auto bytes =
            test::compiled("kfast 1\ncanvas 60 40 frames=10\ninput knob\n"
                           "object a fill=red { rect 0 0 9 9; track x input=knob { at 0 0; at 1 9 } }\n"
                           "object b fill=lime" +
                           bound + " { key 0 law=hold { rect 0 0 2 2 }; key 1 { rect 0 0 60 40 } }\n");
        const FitReport report = report_of(bytes);
        CHECK(report.speed.frames.size() == 2 * 10 + 3 + 64);
        CHECK(report.late_with_inputs.frames == 64);
        CHECK(report.speed.frames.front().instructions < report.speed.worst().instructions / 4); // at rest
        CHECK((report.speed.worst().bytes > 60 * 40) == (bound == " input=knob"));
    }
}

TEST_CASE("pictures that are late only while inputs move are said to be so")
{
    Target slow = desk();
    slow.bus.clock = 600e3;
    const auto bytes =
        test::compiled("kfast 1\ncanvas 60 40 frames=10\ninput knob\nobject b fill=lime "
                       "input=knob { key 0 law=hold { rect 0 0 2 2 }; key 1 { rect 0 0 60 40 } }\n");
    const FitReport report = report_of(bytes, slow);
    CHECK(report.late.late == 0);
    CHECK(report.late_with_inputs.late > 0);
    CHECK(report.lateness_text().ends_with(" while its inputs move"));
    CHECK(report.fits());
}

TEST_CASE("a scene whose pictures are all late while its inputs move is too slow, though it rests for long")
{
    const auto bytes = test::compiled("kfast 1\ncanvas 60 40 frames=100\ninput knob\nobject b fill=lime { "
                                      "rect 0 0 40 40; track x input=knob { at 0 0; at 1 20 } }\n");
    CHECK(report_of(bytes).fits());
    Target slow = desk();
    slow.bus.clock = 50e3;
    const FitReport report = report_of(bytes, slow);
    CHECK(report.late.late == 0);
    CHECK(report.late_with_inputs.is_all());
    CAPTURE(report.slowness);
    CHECK(
        report.slowness.starts_with("speed: while its inputs move all pictures are late, the worst takes "));
    CHECK(report.slowness.find(" ms, but 30 fps leave 33.3 ms for each: the bus takes longest, ") !=
          std::string::npos);
    CHECK(!report.fits());
}

TEST_CASE("texts are looked at full of the letters that cost most, all of them changing")
{
    const auto frames_of = [](const std::string& glyphs, int max) {
        const auto bytes =
            test::compiled("kfast 1\ncanvas 60 40 frames=10\ninput t kind=text glyphs=\"" + glyphs +
                           "\" max=" + std::to_string(max) +
                           "\nobject a stroke=red { text input=t at=\"2,30\" size=20 font=hershey-sans }\n");
        return report_of(bytes).speed;
    };
    const Speed few = frames_of("18", 1);
    const Speed many = frames_of("18", 5);
    const Speed plain = frames_of("1l", 5);
    CHECK(few.frames.size() == 2 * 10 + 3 + 64);
    CHECK(many.worst().instructions > 3 * few.worst().instructions);
    CHECK(many.worst().instructions > 1.5 * plain.worst().instructions);
    CHECK(many.frames.front().instructions < many.worst().instructions / 4); // at rest
    CHECK(2 * many.outlines.bytes > 5 * few.outlines.bytes);
}

TEST_CASE("a scene that is too slow is told what takes longest")
{
    const auto bytes =
        test::compiled("kfast 1\ncanvas 60 40 frames=10\nobject a fill=red { key 0 { rect 0 0 9 40 }; key 10 "
                       "{ rect 51 0 9 40 } }\n"
                       "object b fill=lime { key 0 { rect 0 0 2 2 }; key 10 { rect 50 0 2 2 } }\n");
    CHECK(report_of(bytes).slowness.empty());
    Target target = desk();
    target.clock = 100e3;
    const std::string by_processor = report_of(bytes, target).slowness;
    CHECK(by_processor.find("can be reached: the processor takes longest, in the worst frame ") !=
          std::string::npos);
    CHECK(by_processor.ends_with(" % of it for object 1"));
    target = desk();
    target.bus.clock = 100e3;
    const std::string by_bus = report_of(bytes, target).slowness;
    CHECK(by_bus.find("can be reached: the bus takes longest, ") != std::string::npos);
    CHECK(by_bus.ends_with(" bytes"));
}

TEST_CASE("of the player counts what the scene needs, or all of it")
{
    const std::size_t all = costs_of(desk().processor).code;
    const auto plain = test::compiled("kfast 1\ncanvas 60 40\nobject a fill=red { rect 0 0 2 2 }\n");
    const auto stroked =
        test::compiled("kfast 1\ncanvas 60 40\nobject a fill=red stroke=lime { rect 0 0 2 2 }\n");
    const FlashNeed bare = report_of(plain).flash;
    CHECK(bare.features == FeatureSet{});
    CHECK(bare.player == player_code({}, desk().processor));
    CHECK(report_of(stroked).flash.features == FeatureSet{Feature::strokes});
    CHECK(report_of(stroked).flash.player > bare.player);
    CHECK(report_of(stroked).flash.player < all);
    FeatureSet every;
    for (std::size_t number = 0; number < feature_count; ++number)
        every.add(static_cast<Feature>(number));
    CHECK(player_code(every, desk().processor) == all);
    Target target = desk();
    target.has_every_feature = true;
    CHECK(report_of(plain, target).flash.player == all);
    CHECK_FALSE(report_of(plain, target).flash.features);
    CHECK(report_of(plain, target).fits());
    target.flash = all - 1;
    CHECK_FALSE(report_of(plain, target).fits());
    target.has_every_feature = false;
    const FitReport report = report_of(plain, target);
    CHECK(report.fits());
    REQUIRE(report.notes.size() == 1);
    CHECK(report.notes.front() ==
          "it fits if the program has only what the scene needs of the player, not all of it, which takes " +
              std::to_string(all - bare.player) +
              " bytes more: docs/library.md, \"Only what a scene needs\"");
}

TEST_CASE("the stack has no less than its bound")
{
    const auto bytes = test::compiled("kfast 1\ncanvas 60 40\nobject a fill=red { rect 0 0 2 2 }\n");
    CHECK(report_of(bytes).ram.stack >= 6144);
}

}
