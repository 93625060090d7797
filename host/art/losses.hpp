#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace kfast::art {

/// Something in a file that the scene does not have, or not unchanged.
struct Loss {
    std::string feature;        ///< what: "gradient"
    std::string layer;          ///< where: names from the outermost, "body / arm"; empty: the whole file
    std::optional<double> time; ///< from which frame of the scene on, if not all along
    std::string instead;        ///< what the scene has: "its mean colour"
    friend bool operator==(const Loss&, const Loss&) = default;
};

/// What an importer could not convert. The same loss is kept once, and at most a thousand of them.
class Losses {
public:
    static constexpr std::size_t max = 1000;

    void add(Loss loss);

    std::span<const Loss> list() const { return list_; }
    /// The number of those that are no longer in the list.
    std::size_t beyond() const { return beyond_; }
    bool empty() const { return list_.empty(); }

private:
    std::vector<Loss> list_;
    std::size_t beyond_ = 0;
};

}
