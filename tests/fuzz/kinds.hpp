#pragma once

#include <cstddef>
#include <map>
#include <string>

namespace kfast::test {

/// How often everything that docs/format.md describes occurs in compiled scenes.
class Census {
public:
    /// `kind` is a section and what it describes, "Forms: end", `variant` the number that it has there.
    void see(const std::string& kind, std::size_t variant) { ++seen_[kind][variant]; }

    /// Prints a line for each that occurs, and on standard error those that do not. Whether all occur.
    bool print() const;

private:
    std::size_t count(const std::string& kind, std::size_t variant) const;

    std::map<std::string, std::map<std::size_t, std::size_t>> seen_;
};

}
