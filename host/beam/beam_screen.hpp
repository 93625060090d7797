#pragma once

#include "core/beam/beam_profile.hpp"
#include "host/beam/beam_deflection.hpp"
#include "host/beam/light_sheet.hpp"
#include "host/beam/phosphor.hpp"
#include "host/picture/picture.hpp"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace kfast {

/// What is at the end of the beam and does not concern the firmware: how the beam is moved, and how its
/// light looks.
struct BeamDisplay {
    std::string_view name; ///< of the ready profile that is made for it
    BeamDeflection deflection;
    double spot;      ///< how wide it is where it has half its brightness, in percent of the field's width
    double half_life; ///< milliseconds until half of the light is gone, for the phosphor and the eye together
    Phosphor phosphor;
};

/// The display for a ready profile (profile_choices()).
const BeamDisplay& display_of(std::string_view profile_name);

/// A picture that the beam drew over and over: its points are repeated, beginning with the first, from
/// `begin` until before `end`. Times are counted in points.
struct DrawnPicture {
    std::vector<BeamPoint> points; ///< at least one
    std::int64_t begin = 0;
    std::int64_t end = 0;
};

/// The screen of a vector display, as a camera sees it: the field in the middle, with a margin.
class BeamScreen {
public:
    /// How many pixels of a screen of that size the field is wide and high; it is in the middle.
    static double field_side_on(Size size);

    /// It is exposed for a line at the profile's default speed in a picture of that many points, drawn over
    /// and over.
    BeamScreen(const BeamProfile& profile, const BeamDisplay& display, Size size,
               std::int64_t default_points);

    /// How long light is visible, in points.
    std::int64_t memory() const;
    /// What is visible at the end of the last of `pictures`, which follow each other. There is at least one.
    const Frame& show(std::span<const DrawnPicture> pictures);
    /// Reveals the path of the beam in the last tour of the last picture, wherever it was not lit: for the
    /// next pictures.
    void reveal_travel(bool reveal) { reveals_travel_ = reveal; }

private:
    void expose(const DrawnPicture& picture);
    void develop();
    void draw_travel(const DrawnPicture& picture);
    void draw_way(BeamPlace from, BeamPlace to);
    void mark(BeamPlace place);
    BeamPlace on_screen(BeamPlace place) const;
    double spot_deviation() const;

    BeamDisplay display_;
    Film film_;
    DeflectedBeam beam_;
    LightSheet sheet_;
    double exposure_;
    double fading_;        ///< what is left of light after the time of a point
    double freshness_ = 0; ///< what will be left of light that falls now
    bool reveals_travel_ = false;
    Frame frame_;
};

}
