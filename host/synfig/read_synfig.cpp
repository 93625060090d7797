#include "host/synfig/read_synfig.hpp"

#include "host/synfig/layers/layers_reader.hpp"
#include "host/synfig/values/constant_reader.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>
#include <string_view>

namespace kfast::synfig {
namespace {

constexpr double max_pixels = 100'000;
constexpr double max_frames = 1'000'000;

class CanvasReader {
public:
    CanvasReader(const SourceText& source, art::Losses& losses) : file_{source}, losses_{losses} {}

    art::Document document()
    {
        if (std::string_view{canvas_.name()} != "canvas")
            file_.fail(XmlFile::place(canvas_), "this is no file of Synfig: its outermost element is <" +
                                                    std::string{canvas_.name()} + "> instead of <canvas>");
        art::Document document;
        set_canvas(document);
        ValueReader values{file_, document.frame_rate, losses_};
        Evaluator evaluator{values, file_, losses_};
        art::Budget budget;
        Reading reading{file_,
                        values,
                        evaluator,
                        losses_,
                        budget,
                        to_canvas(document),
                        pixels_per_unit_,
                        document.width,
                        document.height,
                        begin_,
                        document.frame_rate,
                        document.frames,
                        gamma(),
                        {},
                        {}};
        document.background = background();
        document.nodes = read_layers(canvas_, reading, {{begin_, document.frame_rate}, "", 0, {}});
        document.rigs = std::move(reading.rigs);
        set_markers(document);
        return document;
    }

private:
    double number(const char* name, double default_value, double min, double max) const
    {
        const auto attribute = canvas_.attribute(name);
        if (!attribute)
            return default_value;
        const std::string_view text = attribute.value();
        double value = 0;
        const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
        if (read.ec != std::errc{} || !(value >= min && value <= max))
            file_.fail(XmlFile::place(canvas_),
                       std::string{name} + "=\"" + std::string{text} + "\" of the canvas is out of range");
        return value;
    }

    double time(const char* name, double frame_rate, double default_value) const
    {
        const auto attribute = canvas_.attribute(name);
        const auto found = attribute ? time_of(attribute.value(), frame_rate) : std::optional{default_value};
        if (!found || std::abs(*found) > end_of_time)
            file_.fail(XmlFile::place(canvas_), std::string{name} + "=\"" + attribute.value() +
                                                    "\" of the canvas is no time, such as \"1s 12f\"");
        return *found;
    }

    template <std::size_t count>
    std::array<double, count> numbers(const char* name, std::array<double, count> default_value) const
    {
        std::istringstream text{canvas_.attribute(name).value()};
        text.imbue(std::locale::classic());
        std::array<double, count> found{};
        for (double& one : found)
            if (!(text >> one) || !(std::abs(one) < 1e6))
                return default_value;
        return found;
    }

    void set_canvas(art::Document& document)
    {
        document.width = number("width", 480, 1, max_pixels);
        document.height = number("height", 270, 1, max_pixels);
        document.frame_rate = number("fps", 24, 0.01, 1000);
        begin_ = time(canvas_.attribute("begin-time") ? "begin-time" : "start-time", document.frame_rate, 0);
        const double end = time("end-time", document.frame_rate, begin_);
        const double frames = std::round((end - begin_) * document.frame_rate * 1024) / 1024;
        if (frames > max_frames)
            file_.fail(XmlFile::place(canvas_), "the animation is longer than a million frames");
        document.frames = std::max(1.0, frames);
    }

    /// The picture has square pixels: where the view box has another shape than the canvas, heights win.
    art::Affine to_canvas(const art::Document& document)
    {
        const auto box = numbers<4>("view-box", {-4, 2.25, 4, -2.25});
        const double width = box[2] - box[0];
        const double height = box[1] - box[3];
        constexpr double min = 1e-6;
        if (std::abs(width) < min || std::abs(height) < min)
            file_.fail(XmlFile::place(canvas_), "the view-box of the canvas is empty");
        pixels_per_unit_ = std::abs(document.height / height);
        const double across = document.width / width;
        if (std::abs(std::abs(across) - pixels_per_unit_) > 1e-3 * pixels_per_unit_)
            losses_.add({"pixels that are not square", "", {}, "square pixels"});
        return {std::copysign(pixels_per_unit_, across),
                0,
                0,
                std::copysign(pixels_per_unit_, -height),
                -box[0] * std::copysign(pixels_per_unit_, across),
                box[1] * std::copysign(pixels_per_unit_, height)};
    }

    /// Files before version 1.2 have linear colours.
    std::array<double, 3> gamma() const
    {
        const std::string_view version = canvas_.attribute("version").value();
        const double default_value = version == "1.0" || version.starts_with("0.") ? 2.2 : 1;
        return {number("gamma-r", default_value, 0.01, 100), number("gamma-g", default_value, 0.01, 100),
                number("gamma-b", default_value, 0.01, 100)};
    }

    /// Synfig 1.5.1 paints it unchanged, without the gamma that layers get.
    std::optional<art::Rgb> background() const
    {
        const auto colour = numbers<4>("bgcolor", {0, 0, 0, 0});
        if (colour[3] <= 0)
            return {};
        return art::Rgb{std::clamp(colour[0], 0.0, 1.0), std::clamp(colour[1], 0.0, 1.0),
                        std::clamp(colour[2], 0.0, 1.0)};
    }

    void set_markers(art::Document& document) const
    {
        for (const pugi::xml_node key : canvas_.children("keyframe")) {
            const std::string name = key.text().get();
            const auto moment = time_of(key.attribute("time").value(), document.frame_rate);
            const double frame = moment ? (*moment - begin_) * document.frame_rate : -1;
            if (!name.empty() && frame >= 0 && frame <= document.frames)
                document.markers.push_back({name, std::round(frame * 1024) / 1024, 0});
            else if (!name.empty())
                losses_.add({"key frame \"" + name + "\" outside of the animation", "", {}, "nothing"});
        }
    }

    XmlFile file_;
    art::Losses& losses_;
    pugi::xml_node canvas_ = file_.root();
    double begin_ = 0;
    double pixels_per_unit_ = 1;
};

}

art::Document read_synfig(const SourceText& source, art::Losses& losses)
{
    return CanvasReader{source, losses}.document();
}

}
