#pragma once

#include "host/art/losses.hpp"

#include <cstddef>
#include <memory>
#include <pugixml.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kfast::svg {

/// "fill: red", perhaps with "!important".
struct Declaration {
    std::string property;
    std::string value;
    bool important = false;
};

/// The declarations between the braces of a rule, or in an attribute "style".
std::vector<Declaration> declarations(std::string_view text);

/// What of an element selectors look at.
struct StyledElement {
    std::string_view name;
    std::string_view id;
    std::string_view classes;
};

/// What an element must match: "rect", ".thin", "#nose", or all of these at once.
struct Compound {
    std::string type; ///< empty: any
    std::vector<std::string> ids;
    std::vector<std::string> classes;
};

/// A compound, and those that elements around it must match, from the inside to the outside.
struct Selector {
    struct Outer {
        Compound compound;
        bool is_parent = false; ///< the parent itself, not one further out
    };
    Compound compound;
    std::vector<Outer> around;
    int specificity = 0;

    /// Of an element and those around it, from the inside to the outside, at least one. Adds to `cost` what
    /// that took: the more the longer the names are that it looks at.
    bool matches(std::span<const StyledElement> path, std::size_t& cost) const;
};

struct Rule {
    Selector selector;
    std::shared_ptr<const std::vector<Declaration>> declarations; ///< of all selectors of the rule
};

/// The rules of all elements "style" of a text, in their order.
class StyleSheet {
public:
    /// Adds those of all elements "style" below `root`. What is not understood is added to `losses`.
    void add_elements(pugi::xml_node root, art::Losses& losses);

    /// The rules that match, the winner last. Throws Failure if matching costs too much, all elements
    /// together.
    std::vector<const Rule*> matching(pugi::xml_node element);

private:
    /// `depth` counts the rules with @ around it.
    void add(std::string_view css, int depth, art::Losses& losses);
    void add_rule(std::string_view selectors, std::string_view body, art::Losses& losses);
    void add_at_rule(std::string_view prelude, std::string_view body, int depth, art::Losses& losses);

    std::vector<Rule> rules_;
    std::size_t cost_ = 0;
};

}
