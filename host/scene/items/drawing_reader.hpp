#pragma once

#include "host/geometry/outline.hpp"
#include "host/geometry/wire.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"
#include "host/schema/node_form.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace kfast::scene {

/// The nodes that a drawing consists of: shapes, uses of symbols, and `empty`.
std::vector<std::string_view> drawn_names();
bool is_drawn(std::string_view name);

/// Collects the strokes of one drawing.
class DrawingReader {
public:
    explicit DrawingReader(SceneContext& context) : context_{context} {}

    /// Adds the strokes of `node`, for which is_drawn() holds; reports it when it is wrong.
    void read(const kdl::Node& node);
    /// Reads all of `nodes`, until there are too many errors.
    void read(std::span<const kdl::Node* const> nodes);
    Drawing take() { return std::move(drawing_); }
    /// See Key::depths.
    Drawing take_depths() { return std::move(depths_); }
    /// See Key::sectors.
    std::vector<SectorStroke> take_sectors() { return std::move(sectors_); }
    /// See Key::letters.
    std::vector<std::size_t> take_letters() { return std::move(letters_); }
    /// What take() returns, before rounding.
    std::vector<Outline> take_outlines() { return std::move(outlines_); }
    /// How deeply symbols that have been copied are nested.
    int depth() const { return depth_; }

private:
    void read_strokes(const kdl::Node& node);
    void read_empty(const kdl::Node& node);
    void copy(const kdl::Node& node);
    bool goes_with_others(const kdl::Node& node);
    bool has_capacity(std::size_t points, const kdl::Node& node);
    bool add(Outline outline, const kdl::Node& node);
    bool add(const Wire& wire, const kdl::Node& node);

    SceneContext& context_;
    Drawing drawing_;
    Drawing depths_;
    std::vector<Outline> outlines_;
    std::vector<SectorStroke> sectors_;
    std::vector<std::size_t> letters_;
    const kdl::Node* last_node_ = nullptr; ///< with a stroke
    std::size_t points_ = 0;
    int depth_ = 0;
    bool has_strokes_ = false;       ///< nodes, at least
    bool is_empty_ = false;          ///< says so
    std::optional<bool> has_depths_; ///< of the first node
    bool is_mixed_ = false;          ///< has been reported
};

/// The ids for `names`, some of which are nodes that draw.
std::vector<std::string_view> drawn_ids(std::vector<std::string_view> names);
NodeSchema empty_schema();

}
