#include "host/lottie/layers/composition_symbol.hpp"

#include "host/lottie/drawings/extent.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kfast::lottie {
namespace {

constexpr double by_rounding = 1e-6;  ///< frames: a difference by computing alone
constexpr double finest = 1.0 / 64;   ///< frames: what is later or earlier by that looks the same
constexpr double max_speed = 16;      ///< of a scene
constexpr double speed_steps = 65536; ///< in which a scene stores it

/// What the composition draws in the frames of the symbol; nothing if that depends on where it is used.
std::optional<std::vector<art::Node>> read_nodes(const CompositionSymbol& symbol, const Reading& reading,
                                                 Animation& animation)
{
    art::Losses losses;
    const LayerTime time{.start = -symbol.first * symbol.stretch, .stretch = symbol.stretch};
    const Reading inner{reading.budget, losses, time, reading.layer, reading.depth, reading.symbols};
    const Around anywhere{.is_symbol = true};
    auto looked_through = animation.looked_through;
    const bool before = std::exchange(animation.depends_on_place, false);
    std::vector<art::Node> nodes =
        read_composition({*symbol.layers, &anywhere, {0, symbol.frames}}, animation, inner);
    if (std::exchange(animation.depends_on_place, before)) {
        animation.looked_through = std::move(looked_through);
        return std::nullopt;
    }
    for (const art::Loss& loss : losses.list())
        reading.losses.add(loss);
    return nodes;
}

/// Adds the symbol, unless it cannot be one, and notes what came of it.
const CompositionSymbol& added(CompositionSymbol symbol, const std::string& name, const Reading& reading,
                               Animation& animation)
{
    if (auto nodes = read_nodes(symbol, reading, animation); nodes && !reading.symbols->is_full()) {
        const Box box = box_in(*nodes, {0, symbol.frames}, reading.symbols->boxes, reading.budget);
        symbol.index = reading.symbols->add({name, symbol.frames, symbol.loop, std::move(*nodes)}, box);
    }
    animation.composition_symbols.push_back(symbol);
    return animation.composition_symbols.back();
}

std::string symbol_name(const Layer& layer)
{
    const std::string name = given_name(layer.json);
    return name.empty() ? identifier_at(layer.json, "refId") : name;
}

/// The use that shows by an even time what is seen of the layer; nothing if the symbol is another part of the
/// composition, or cannot be that fast.
std::optional<art::Use> even_use(const CompositionSymbol& symbol, const LayerTime& even,
                                 const art::Span& seen)
{
    const double exact = symbol.stretch / even.stretch;
    const double speed = std::round(exact * speed_steps) / speed_steps;
    const double begin = even.scene_frame(symbol.first);
    const auto time_at = [&](double frame) { return (frame - begin) * exact; };
    const auto [low, high] = std::minmax({time_at(seen.from), time_at(seen.to)});
    const double late = std::max(std::abs(low), std::abs(high)) * std::abs(speed / exact - 1);
    if (speed == 0 || std::abs(speed) > max_speed || low < -by_rounding ||
        high > symbol.frames + by_rounding || late > finest)
        return std::nullopt;
    const double delay = speed > 0 ? begin : begin + symbol.frames / exact;
    return art::Use{.symbol = symbol.index.value_or(0), .delay = delay, .speed = speed};
}

/// A symbol that has all that is seen of the layer, and begins at frame 0 if that is possible.
CompositionSymbol even_symbol(const Json& layers, const LayerTime& even, const Layer& layer,
                              const Animation& animation)
{
    CompositionSymbol symbol{.layers = &layers,
                             .stretch = std::abs(even.stretch),
                             .frames = animation.frames,
                             .loop = {},
                             .index = {}};
    const auto frame_at = [&](double time) { return (time - even.start) / even.stretch; };
    const auto [first, last] = std::minmax({frame_at(layer.seen.from), frame_at(layer.seen.to)});
    if (first < 0 || last * symbol.stretch > symbol.frames)
        symbol.first = std::floor(first);
    symbol.frames = std::max(symbol.frames, (last - symbol.first) * symbol.stretch);
    return symbol;
}

class EvenUse {
public:
    EvenUse(const Layer& layer, const Json& layers, const LayerTime& even, const Reading& reading,
            Animation& animation)
        : layer_{layer}, layers_{layers}, even_{even}, reading_{reading}, animation_{animation}
    {
    }

    std::optional<art::Use> find() const
    {
        constexpr int most = 4; // symbols of one composition
        int tried = 0;
        for (const CompositionSymbol& symbol : animation_.composition_symbols) {
            if (symbol.layers != &layers_ || symbol.loop)
                continue;
            ++tried;
            const auto use = even_use(symbol, even_, layer_.seen);
            if (!symbol.index)
                return std::nullopt;
            if (use)
                return used(*use);
        }
        if (tried == most)
            return std::nullopt;
        const CompositionSymbol symbol =
            added(even_symbol(layers_, even_, layer_, animation_), symbol_name(layer_), reading_, animation_);
        const auto use = even_use(symbol, even_, layer_.seen);
        return symbol.index && use ? std::optional{used(*use)} : std::nullopt;
    }

private:
    /// One that goes backwards needs an end.
    art::Use used(const art::Use& use) const
    {
        if (use.speed < 0)
            reading_.symbols->list[use.symbol].loop = Loop::once;
        return use;
    }

    const Layer& layer_;
    const Json& layers_;
    const LayerTime& even_;
    const Reading& reading_;
    Animation& animation_;
};

bool can_have_symbols(const Reading& reading, const Animation& animation)
{
    constexpr std::size_t most = 512; // tried
    return reading.symbols && animation.composition_symbols.size() < most;
}

}

std::optional<art::Use> use_looped(const Layer& layer, const Json& layers, const LoopedTime& time,
                                   const Reading& reading, Animation& animation)
{
    if (!can_have_symbols(reading, animation))
        return std::nullopt;
    const CompositionSymbol wanted{.layers = &layers,
                                   .first = std::min(time.begin, time.end),
                                   .stretch = time.period / std::abs(time.end - time.begin),
                                   .frames = time.period,
                                   .loop = time.loop,
                                   .index = {}};
    const auto is_wanted = [&](const CompositionSymbol& symbol) {
        return symbol.layers == wanted.layers && symbol.first == wanted.first &&
               symbol.stretch == wanted.stretch && symbol.frames == wanted.frames &&
               symbol.loop == wanted.loop;
    };
    const auto known = std::ranges::find_if(animation.composition_symbols, is_wanted);
    const CompositionSymbol symbol = known != animation.composition_symbols.end()
                                         ? *known
                                         : added(wanted, symbol_name(layer), reading, animation);
    if (!symbol.index)
        return std::nullopt;
    return art::Use{.symbol = *symbol.index, .delay = time.from, .speed = time.end > time.begin ? 1.0 : -1.0};
}

std::optional<art::Use> use_evenly(const Layer& layer, const Json& layers, const LayerTime& time,
                                   const Reading& reading, Animation& animation)
{
    if (!can_have_symbols(reading, animation) || animation.uses[&layers] < 2)
        return std::nullopt;
    return EvenUse{layer, layers, time, reading, animation}.find();
}

}
