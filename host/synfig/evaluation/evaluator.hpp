#pragma once

#include "host/art/losses.hpp"
#include "host/synfig/evaluation/value_reader.hpp"
#include "host/synfig/values/value_node.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kfast::synfig {

/// What replaces value nodes that Evaluator does not know.
inline constexpr const char* instead_of_value = "nothing, as if it was 0, or what it starts from";

/// Evaluates values at a time, in seconds.
class Evaluator {
public:
    Evaluator(ValueReader& reader, const XmlFile& file, art::Losses& losses)
        : reader_{reader}, file_{file}, losses_{losses}
    {
    }

    /// False for value nodes that evaluate to nothing, or only to what they would be without their own
    /// effect: the caller is to report them.
    static bool knows(std::string_view kind);
    /// Throws Failure when that takes too many steps. Numbers, places and colours are finite.
    Value at(const ValueNode& node, double time);
    /// The bone of that name at that time; none: the root, where the canvas begins.
    Bone bone(const std::string& guid, double time);

    // The components of value nodes; for the laws in other files.
    Value link(const ValueNode& node, std::string_view name, double time);
    double number(const ValueNode& node, std::string_view name, double time, double default_value = 0);
    bool truth(const ValueNode& node, std::string_view name, double time, bool default_value = false);
    Vec2 spot(const ValueNode& node, std::string_view name, double time);

private:
    using Law = Value (*)(Evaluator&, const ValueNode&, double);
    static Law law_of(std::string_view kind);

    ValueReader& reader_;
    const XmlFile& file_;
    art::Losses& losses_;
    int depth_ = 0;
    std::size_t steps_ = 0;
};

/// Evaluates a value node at a time, in seconds.
using ValueLaw = Value (*)(Evaluator&, const ValueNode&, double);

/// The laws, by the names of the elements that have them.
using ValueLaws = std::vector<std::pair<std::string_view, ValueLaw>>;

/// The laws of sums, products and other functions of numbers.
ValueLaws arithmetic_laws();

/// To the nearest whole number, halves up.
Value rounded(const Value& value);

/// The laws of bones, and what they deform.
ValueLaws bone_laws();

/// The laws of values that are composed of others, or decomposed.
ValueLaws composite_laws();

/// The laws of lists, whose entries come and go.
ValueLaws list_laws();

/// The laws of positions, directions and widths along splines.
ValueLaws spline_laws();

}
