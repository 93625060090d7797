#pragma once

#include "host/art/losses.hpp"
#include "host/synfig/values/constant_reader.hpp"
#include "host/synfig/values/value_node.hpp"
#include "host/synfig/values/xml_file.hpp"

#include <map>
#include <set>
#include <string>
#include <string_view>

namespace kfast::synfig {

/// Reads the values of a file: inline ones, and those that are referred to by an id or a guid.
class ValueReader {
public:
    ValueReader(const XmlFile& file, double frame_rate, art::Losses& losses)
        : file_{file}, frame_rate_{frame_rate}, constants_{file, frame_rate}, losses_{losses}
    {
    }

    /// Reads the element of a value. Throws Failure when values contain themselves, or are damaged.
    ValueNodePtr read(pugi::xml_node element);
    /// Reads the value inside of an element, or the one its attribute `use` names. Nothing with neither.
    ValueNodePtr read_inside(pugi::xml_node holder);
    /// The value with an id; nothing if it is in another file, which is a loss.
    ValueNodePtr with_id(std::string_view id, std::size_t place);
    /// Nothing if there is no such bone.
    ValueNodePtr bone(std::string_view guid);

private:
    ValueNodePtr read_new(pugi::xml_node element);
    void read_waypoints(pugi::xml_node element, ValueNode& node);
    Waypoint waypoint(pugi::xml_node element, const std::string& type);
    Interpolation interpolation(pugi::xml_attribute attribute, Interpolation default_value) const;
    void read_entries(pugi::xml_node element, ValueNode& node);
    void read_switchings(pugi::xml_attribute times, bool on, Entry& entry);
    void read_links(pugi::xml_node element, ValueNode& node);

    const XmlFile& file_;
    double frame_rate_;
    ConstantReader constants_;
    art::Losses& losses_;
    int depth_ = 0;
    std::map<std::size_t, ValueNodePtr> known_; ///< by the offset of the element
    std::set<std::size_t> begun_;
};

}
