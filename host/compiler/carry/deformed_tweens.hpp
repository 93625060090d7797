#pragma once

#include "core/scene/item_view.hpp"
#include "core/time/time.hpp"
#include "core/time/velocity_law.hpp"
#include "host/compiler/match/match_by_length.hpp"
#include "host/scene/model.hpp"
#include "host/text/diagnostic.hpp"
#include "host/text/source.hpp"

#include <cstdint>
#include <vector>

namespace kfast {

/// What deforms `object`.
inline Deformer deformer_of(const scene::Object& object)
{
    if (object.skin)
        return Deformer::bones;
    return object.backbone_keys.empty() ? Deformer::none : Deformer::backbones;
}

/// A key as it is stored, and the tween from it to the next. The last one leads nowhere: both of its ends are
/// its drawing.
struct KeyTween {
    Time time;
    LawPair laws;
    MatchedDrawings ends;
    SourceSpan place; ///< of the key
};

/// All tweens of an object.
struct KeyTweens {
    std::vector<KeyTween> tweens;
    /// For tweens of drawings that backbones deform: 2^unit_bits sixteenths of a pixel represent a segment.
    std::uint32_t unit_bits = 0;
};

/// The tweens of `object`, which has backbones, in coordinates relative to these (docs/format.md,
/// "Backbones"). `drawn` are the same tweens without backbones. Points in no cell are a warning at their key;
/// a tween that takes more points than a drawing holds is an error there.
KeyTweens deformed_tweens(const scene::Object& object, const std::vector<KeyTween>& drawn,
                          Diagnostics& diagnostics);

}
