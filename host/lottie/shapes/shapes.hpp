#pragma once

#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"
#include "host/lottie/drawings/dashes.hpp"
#include "host/lottie/drawings/moving_drawing.hpp"
#include "host/lottie/values/channel.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace kfast::lottie {

struct SymbolTable;

/// The context of reading, from layer to layer.
struct Reading {
    art::Budget& budget;
    art::Losses& losses;
    LayerTime time;
    std::string layer; ///< for losses: "body / arm"
    int depth = 0;     ///< of layers and groups around
    /// Null: nothing becomes a symbol, for what is around changes what is drawn itself. `time.seen` is
    /// bounded otherwise.
    SymbolTable* symbols = nullptr;
};

/// What a shape layer draws: its "shapes", the lowest of the result first.
std::vector<art::Node> read_shapes(const Json& shapes, const Reading& reading);

/// "ks" of a layer or "tr" of a group, without its opacity "o".
art::Transform read_transform(const Json& transform, const Reading& reading);

/// A path before it was trimmed, for a shape of which all paths are trimmed alike.
struct UntrimmedPath {
    MovingDrawing drawing;
    std::shared_ptr<const art::Trim> trim; ///< the same one for all paths that one modifier trims
    std::size_t index = 0;                 ///< among these
    std::size_t count = 0;
};

/// A path of a shape layer, with what modifiers have made of it.
struct PathItem {
    std::string name;
    MovingDrawing drawing;
    /// The same picture as the scene language draws it, which begins elsewhere: for what is not cut.
    std::optional<MovingDrawing> plain;
    std::optional<UntrimmedPath> untrimmed; ///< if what changed it last is its only trim, and moves
    bool is_trimmed = false;
    int modifiers = 0; ///< that it has gone through
};

/// A style that paints all paths before it in its list, and in the groups before it, as one.
struct StyleItem {
    std::string name;
    std::optional<art::Fill> fill; ///< or
    std::optional<art::StrokeStyle> stroke;
    Dashes dashes; ///< of the line
};

/// A repeater as the scene language has it.
struct CopySet {
    art::Copies copies;
    art::Transform place;   ///< of the lowest copy, and of all together
    art::Transform content; ///< of what is copied, within each
};

struct ShapeItem;

struct GroupItem {
    std::string name;
    art::Transform transform;
    art::Channel opacity = {1};
    std::vector<art::Span> shown = {{}};
    std::vector<ShapeItem> items;
    std::shared_ptr<const CopySet> copies = {}; ///< if it is a copy, and all of them can be drawn as one use
    bool is_first_copy = false;
};

struct ShapeItem {
    std::variant<PathItem, StyleItem, GroupItem> content;
};

/// All paths of a list and of its groups, in their order.
std::vector<PathItem*> paths_of(std::vector<ShapeItem>& items);

/// What a list draws, the lowest first; the first item of the list is on top.
std::vector<art::Node> painted(const std::vector<ShapeItem>& items, const Reading& reading);

/// Whether a type "ty" is one of those that read_path_item() reads.
bool is_path(std::string_view type);

/// A path ("sh"), a rectangle ("rc"), an ellipse ("el") or a star ("sr"): "ty" says which.
PathItem read_path_item(const Json& item, const Reading& reading);

/// After this, copies are drawn one by one: they may differ.
void part_copies(std::vector<ShapeItem>& items);

/// The copies of a repeater ("rp") in place of the items before it: groups that paint the same, the topmost
/// first.
std::vector<ShapeItem> repeated(const std::vector<ShapeItem>& items, const Json& repeater,
                                const Reading& reading);

/// Whether a type "ty" is one of those that read_style_item() reads.
bool is_style(std::string_view type);

/// A fill ("fl"), a stroke ("st"), or one by a gradient ("gf", "gs"), which gets its mean colour.
StyleItem read_style_item(const Json& item, const Reading& reading);

}
