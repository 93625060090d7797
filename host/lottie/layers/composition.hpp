#pragma once

#include "host/art/budget.hpp"
#include "host/art/document/document.hpp"
#include "host/art/geometry/affine.hpp"
#include "host/art/losses.hpp"
#include "host/lottie/drawings/symbol_table.hpp"
#include "host/lottie/shapes/shapes.hpp"
#include "host/lottie/values/json.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace kfast::lottie {

/// A composition that was tried to be read as a symbol.
struct CompositionSymbol {
    const Json* layers = nullptr;
    double first = 0;                 ///< its frame at which the symbol begins
    double stretch = 1;               ///< frames of the symbol for each of its frames, above 0
    double frames = 1;                ///< of the symbol
    std::optional<Loop> loop;         ///< of its time; nothing: it goes on evenly
    std::optional<std::size_t> index; ///< into SymbolTable::list; nothing: it cannot be a symbol
};

/// A file while it is read.
struct Animation {
    const Json& root;
    art::Losses& losses;
    double width = 0;
    double height = 0;
    double first = 0; ///< frame of the file at which the scene begins
    double frames = 1;
    double frame_rate = 30;
    std::map<std::string, const Json*> assets = {}; ///< by "id"
    art::Budget budget = {};
    std::size_t tags = 0;                         ///< art::Node::parent_tag that are given
    std::vector<std::string> open = {};           ///< precompositions around what is being read
    std::set<const Json*> looked_through = {};    ///< layers whose unread members are reported
    std::map<const Json*, std::size_t> uses = {}; ///< of the layers of a composition, by layers of others
    SymbolTable symbols = {};
    std::vector<CompositionSymbol> composition_symbols = {};
    /// Something of a symbol could not be read without knowing where it will be.
    bool depends_on_place = false;
};

/// What the transforms of layers around another one do: a list from the innermost outwards.
struct Around {
    const Around* outer = nullptr;
    const art::Transform* transform = nullptr; ///< null: the placement is unknown
    bool is_symbol = false;                    ///< for that is where it is used
};

/// Whether the placement is unknown because a symbol is around.
bool is_within_symbol(const Around* around);

/// How many points have to be computed to know the placement.
std::size_t weight(const Around* around);

/// The matrix to the canvas; nothing if that is not known.
std::optional<art::Affine> canvas_matrix(const Around* around, double time);

/// Layers that can refer to each other: the file's, or those of a precomposition.
struct Composition {
    const Json& layers; ///< the uppermost first
    const Around* around = nullptr;
    /// When it is visible, in the frames that Reading::time leads to.
    art::Span seen = {};
};

/// What they draw, the lowest first.
std::vector<art::Node> read_composition(const Composition& composition, Animation& animation,
                                        const Reading& reading);

}
