#pragma once

#include "host/synfig/reading/reading.hpp"

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace kfast::synfig {

/// A layer of the file, and what its parameters are at frames of the scene.
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

    /// Frames at which one of these parameters begins another way.
    std::vector<double> bends(const std::vector<std::string_view>& names) const;
    Tracing tracing(const std::vector<std::string_view>& names, double tolerance) const;
    /// Opaque red, green and blue as pictures have them, by the gamma of the canvas.
    art::Rgb rgb(const Colour& colour) const;
    Colour colour(const art::Rgb& rgb) const; ///< the other way
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

/// How far a number may be off, in the parts of a scene that are no places.
inline constexpr double opacity_tolerance = 1.0 / 1020;
inline constexpr double colour_tolerance = 1.0 / 1020;
inline constexpr double place_tolerance = 1.0 / 128; ///< pixels
inline constexpr double angle_tolerance = 1.0 / 256; ///< degrees
inline constexpr double scale_tolerance = 1.0 / 16384;

}
