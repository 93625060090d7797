#include "host/beam/beam_screen.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace kfast {

namespace {

/// The plates of a scope follow at once, so this is its DAC: an MCP4922 changes by 0.55 V/µs, of 4.1 V, and
/// arrives after 4.5 µs.
constexpr BeamDeflection plates{.bandwidth = 300e3, .damping = 1, .top_speed = 134e3};

/// Chosen: a yoke that arrives within the ten points that the profile crt waits.
constexpr BeamDeflection coils{.bandwidth = 20e3, .damping = 0.75, .top_speed = 6e3};

/// The ILDA test pattern at 30,000 points a second requires a bandwidth of 2.4 kHz. The others are
/// chosen: without overshoot such a mirror lags by the four points of the profile galvo.
constexpr BeamDeflection mirrors{.bandwidth = 2.4e3, .damping = 1, .top_speed = 2.5e3};

/// Spots and half-lives are chosen: those of the eye and of a camera are longer than those of any phosphor
/// for moving pictures.
constexpr std::array displays{
    BeamDisplay{"scope", plates, 0.6, 8, Phosphor::green},
    BeamDisplay{"crt", coils, 0.5, 8, Phosphor::white},
    BeamDisplay{"galvo", mirrors, 0.7, 8, Phosphor::rgb},
};

}

const BeamDisplay& display_of(std::string_view profile_name)
{
    return *std::ranges::find(displays, profile_name, &BeamDisplay::name);
}

namespace {

constexpr double field_share = 0.92; // of the picture's shorter side
constexpr double forgotten = 1e-5;   // what is left of light that is no longer visible
constexpr Colour travel_colour{110, 56, 76};
constexpr std::size_t pixel_bytes = 3;

double fading_of(const BeamDisplay& display, std::uint32_t rate)
{
    return std::exp2(-1000 / (display.half_life * rate));
}

double units_per_pixel(Size size) { return field_side / BeamScreen::field_side_on(size); }

/// A Gaussian is half as high at 1.177 standard deviations.
double deviation_of(const BeamDisplay& display, Size size)
{
    const double width = display.spot / 100 * field_side / units_per_pixel(size);
    return std::max(0.4, width / (2 * std::sqrt(2 * std::numbers::ln2)));
}

/// What makes the middle of a default line, just drawn, a light of 1.
double exposure_of(const BeamProfile& profile, double fading, Size size, double deviation,
                   std::int64_t default_points)
{
    const double points_per_pixel = units_per_pixel(size) / profile.lit_step;
    const double in_the_middle = points_per_pixel / (deviation * std::sqrt(2 * std::numbers::pi));
    const double tours = 1 / (1 - std::pow(fading, static_cast<double>(default_points)));
    return 1 / (in_the_middle * tours);
}

std::span<std::byte, pixel_bytes> pixel(Frame& frame, std::size_t number)
{
    return std::span{frame.pixels}.subspan(pixel_bytes * number).first<pixel_bytes>();
}

Frame black(Size size)
{
    const auto pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    return {std::nullopt, size, std::vector<std::byte>(pixel_bytes * pixels)};
}

}

double BeamScreen::field_side_on(Size size) { return field_share * std::min(size.width, size.height); }

BeamScreen::BeamScreen(const BeamProfile& profile, const BeamDisplay& display, Size size,
                       std::int64_t default_points)
    : display_{display},
      film_{display.phosphor},
      beam_{display.deflection, profile.rate},
      sheet_{size, film_.channels()},
      fading_{fading_of(display, profile.rate)},
      frame_{black(size)}
{
    exposure_ = exposure_of(profile, fading_, size, spot_deviation(), default_points);
}

std::int64_t BeamScreen::memory() const
{
    return static_cast<std::int64_t>(std::ceil(std::log(forgotten) / std::log(fading_)));
}

double BeamScreen::spot_deviation() const { return deviation_of(display_, sheet_.size()); }

BeamPlace BeamScreen::on_screen(BeamPlace place) const
{
    const Size size = sheet_.size();
    const double scale = 1 / units_per_pixel(size);
    return {(size.width - 1) / 2.0 + place.x * scale, (size.height - 1) / 2.0 - place.y * scale};
}

const Frame& BeamScreen::show(std::span<const DrawnPicture> pictures)
{
    sheet_.clear();
    const auto age = static_cast<double>(pictures.back().end - pictures.front().begin);
    freshness_ = exposure_ * std::pow(fading_, age) / beam_.steps();
    beam_.put(pictures.front().points.back().at);
    for (const DrawnPicture& picture : pictures)
        expose(picture);
    sheet_.spread(spot_deviation());
    develop();
    if (reveals_travel_)
        draw_travel(pictures.back());
    return frame_;
}

void BeamScreen::expose(const DrawnPicture& picture)
{
    std::size_t next = 0;
    for (std::int64_t time = picture.begin; time < picture.end; ++time) {
        const BeamPoint& point = picture.points[next];
        next = next + 1 == picture.points.size() ? 0 : next + 1;
        Light light = film_.light_of(point.colour);
        for (float& value : light)
            value *= static_cast<float>(freshness_);
        beam_.pull(point.at, [&](BeamPlace from, BeamPlace to) {
            if (point.is_lit())
                sheet_.add_line(on_screen(from), on_screen(to), light);
        });
        freshness_ /= fading_;
    }
}

void BeamScreen::develop()
{
    const auto pixels = frame_.pixels.size() / pixel_bytes;
    for (std::size_t i = 0; i < pixels; ++i) {
        const Colour colour = film_.developed(sheet_.at(i));
        const auto bytes = pixel(frame_, i);
        bytes[0] = std::byte{colour.red};
        bytes[1] = std::byte{colour.green};
        bytes[2] = std::byte{colour.blue};
    }
}

void BeamScreen::draw_travel(const DrawnPicture& picture)
{
    beam_.put(picture.points.back().at);
    for (const BeamPoint& point : picture.points)
        beam_.pull(point.at, [&](BeamPlace from, BeamPlace to) {
            if (!point.is_lit())
                draw_way(on_screen(from), on_screen(to));
        });
}

void BeamScreen::draw_way(BeamPlace from, BeamPlace to)
{
    const int parts = 1 + static_cast<int>(std::max(std::abs(to.x - from.x), std::abs(to.y - from.y)));
    for (int i = 0; i <= parts; ++i) {
        const double share = static_cast<double>(i) / parts;
        mark({from.x + (to.x - from.x) * share, from.y + (to.y - from.y) * share});
    }
}

/// Drawn under the light.
void BeamScreen::mark(BeamPlace place)
{
    const Size size = sheet_.size();
    const long x = std::lround(place.x);
    const long y = std::lround(place.y);
    if (x < 0 || y < 0 || x >= size.width || y >= size.height)
        return;
    const auto bytes = pixel(frame_, static_cast<std::size_t>(y * size.width + x));
    const auto lighter = [](std::byte seen, std::uint8_t channel) {
        return std::max(seen, std::byte{channel});
    };
    bytes[0] = lighter(bytes[0], travel_colour.red);
    bytes[1] = lighter(bytes[1], travel_colour.green);
    bytes[2] = lighter(bytes[2], travel_colour.blue);
}

}
