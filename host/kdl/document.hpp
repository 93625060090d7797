#pragma once

#include "host/text/source.hpp"

#include <optional>
#include <string>
#include <variant>
#include <vector>

/// The data model of KDL 2.0 (https://kdl.dev), with the location of everything in the source text.
namespace kfast::kdl {

struct Null {
    friend bool operator==(Null, Null) = default;
};

/// A number keeps its digits: `canonical` is how KDL's canonical form writes it, `value` the nearest double
/// (infinite where it exceeds the range of double, 0 where it is too small for it).
struct Number {
    std::string canonical;
    double value = 0;
    friend bool operator==(const Number&, const Number&) = default;
};

struct Value {
    std::optional<std::string> type; ///< the annotation, as in (ms)500
    std::variant<Null, bool, Number, std::string> data;
    SourceSpan place; ///< the whole value with its annotation and quotes
    /// For strings that are in the source byte for byte (no escapes, one line): where their first byte is.
    std::optional<std::size_t> text_offset;

    const Number* number() const { return std::get_if<Number>(&data); }
    const std::string* string() const { return std::get_if<std::string>(&data); }
};

struct Property {
    std::string name;
    SourceSpan name_span;
    Value value;
    std::optional<SourceSpan> replaces = {}; ///< the first of that name in its node, if it stood there before
};

struct Node {
    std::optional<std::string> type;
    std::string name;
    SourceSpan name_span;
    std::vector<Value> arguments;
    /// In source order. A name that is given again replaces the earlier one.
    std::vector<Property> properties;
    std::vector<Node> children;
};

struct Document {
    std::vector<Node> nodes;
};

}
