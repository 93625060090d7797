#pragma once

#include "host/art/budget.hpp"
#include "host/art/document/document.hpp"
#include "host/art/geometry/affine.hpp"
#include "host/art/losses.hpp"
#include "host/synfig/evaluation/evaluator.hpp"
#include "host/synfig/reading/tracing.hpp"

#include <array>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace kfast::synfig {

/// Maps frames of the scene to seconds of a canvas, which may run faster, later, or repeatedly.
class Driver {
public:
    /// The inner time as a function of the outer time, both in seconds.
    struct Gear {
        std::function<double(double)> inside;
        /// The outer times, from the first to the second one, that are the third one inside.
        std::function<std::vector<double>(double, double, double)> around;
    };

    Driver(double begin, double frame_rate) : begin_{begin}, frame_rate_{frame_rate} {}

    double seconds(double frame) const;
    /// All frames of the scene, up to `last`, at which the canvas has that time.
    std::vector<double> frames(double seconds, double last) const;
    Driver with(Gear gear) const;
    bool is_plain() const { return gears_.empty(); } ///< goes with the scene

private:
    double begin_;
    double frame_rate_;
    std::vector<Gear> gears_; ///< the outermost first
};

/// A gear that runs `factor` times as fast, and is at `offset` at the time 0. Both may change.
Driver::Gear running_gear(std::function<double(double)> factor, std::function<double(double)> offset);
/// A gear that runs from `inside` for a duration above 0 or below, repeatedly, after and before `local`.
Driver::Gear looping_gear(double inside, double local, double duration, double shift_before);
/// A gear that follows a value of the file.
Driver::Gear free_gear(std::function<double(double)> time);

/// A tree of bones as a skeleton.
struct LinkedRig {
    std::size_t rig = 0;                      ///< index into Reading::rigs
    std::map<std::string, std::size_t> bones; ///< guids, and indices into the bones of the rig
};

/// The context of reading, for the whole file.
struct Reading {
    const XmlFile& file;
    ValueReader& values;
    Evaluator& evaluator;
    art::Losses& losses;
    art::Budget& budget;
    art::Affine to_canvas;      ///< from units of the file, y up, to pixels
    double pixels_per_unit = 1; ///< above 0
    double width = 0;           ///< of the canvas, in pixels
    double height = 0;
    double begin = 0; ///< seconds
    double frame_rate = 24;
    double frames = 1;
    std::array<double, 3> gamma{1, 1, 1}; ///< of red, green and blue
    std::vector<art::Rig> rigs;
    /// The rigs of bones that things are linked to, by the guid of the root of the tree.
    std::map<std::string, LinkedRig> linked_rigs;
};

/// The scope of layers.
struct Scope {
    Driver clock;
    std::string path; ///< names from the outermost: "body / arm"
    int depth = 0;
    std::function<double(double)> line_scale_factor; ///< by frames; a factor for the width of all lines
    bool is_deformed = false;                        ///< by a skeleton deformation above
};

/// A layer of the file, and the values of its parameters at frames of the scene.
class Layer {
public:
    Layer(pugi::xml_node element, Reading& reading, const Scope& scope);

    const std::string& type() const { return type_; }
    const std::string& name() const { return name_; } ///< its description, or else its type
    std::string path() const;
    const Scope& scope() const { return scope_; }
    Reading& reading() const { return *reading_; }
    /// False if it is switched off.
    bool is_drawn() const { return drawn_; }
    static bool is_drawn(pugi::xml_node element);
    std::string version() const { return element_.attribute("version").value(); }
    bool has(std::string_view name) const { return parameters_.contains(name); }
    const ValueNode* parameter(std::string_view name) const;
    /// The element of the canvas that is the parameter "canvas", or empty.
    pugi::xml_node canvas() const { return canvas_; }

    Value at(std::string_view name, double frame) const;
    double number(std::string_view name, double frame, double default_value) const;
    int whole(std::string_view name, double frame, int default_value) const;
    bool truth(std::string_view name, double frame, bool default_value) const;
    Vec2 spot(std::string_view name, double frame, Vec2 default_value = {}) const;

    /// Frames at which one of these parameters starts to change differently.
    std::vector<double> bends(const std::vector<std::string_view>& names) const;
    Tracing tracing(const std::vector<std::string_view>& names, double tolerance) const;
    /// Opaque red, green and blue as in pictures, by the gamma of the canvas.
    art::Rgb rgb(const Colour& colour) const;
    Colour colour(const art::Rgb& rgb) const; ///< the inverse
    void lose(const std::string& feature, const std::string& instead) const;
    /// Adds a loss for each parameter that is none of these.
    void lose_others(const std::vector<std::string_view>& known) const;

private:
    pugi::xml_node element_;
    Reading* reading_;
    Scope scope_;
    std::string type_;
    std::string name_;
    bool drawn_ = true;
    pugi::xml_node canvas_;
    std::map<std::string, ValueNodePtr, std::less<>> parameters_;
};

/// How far values of each kind may be off: positions in pixels, angles in degrees, the rest as fractions.
inline constexpr double opacity_tolerance = 1.0 / 1020;
inline constexpr double colour_tolerance = 1.0 / 1020;
inline constexpr double place_tolerance = 1.0 / 128; ///< pixels
inline constexpr double angle_tolerance = 1.0 / 256; ///< degrees
inline constexpr double scale_tolerance = 1.0 / 16384;

}
