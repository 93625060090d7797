#pragma once

#include "host/kdl/document.hpp"
#include "host/text/source.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace kfast::schema {

/// A name for a number.
struct Variable {
    std::string name;
    SourceSpan place;                 ///< of the name, where it is defined
    const kdl::Value* definition;     ///< outlives it
    bool is_defined = false;          ///< its definition has been looked at
    std::optional<double> value = {}; ///< none behind that: what is wrong has been reported
    bool is_used = false;
};

/// The variables of a text in their order. All of them are added before any is looked up.
class Variables {
public:
    /// Returns the one of that name that there is already, if there is; then nothing is changed.
    const Variable* add(Variable variable);
    /// Null when there is no such variable.
    Variable* find(std::string_view name);
    std::vector<std::string_view> names() const;
    /// Whether the definition of `variable` needs itself in the end, whatever the order of definitions.
    bool is_circular(const Variable& variable);

    std::vector<Variable>& all() { return all_; }
    bool empty() const { return all_.empty(); }

private:
    void find_needs();

    std::vector<Variable> all_;
    std::unordered_map<std::string, std::size_t> numbers_;
    std::vector<std::vector<std::size_t>>
        needs_; ///< of each, the others in its definition; found when asked for
};

}
