#include "host/scene_text/arrange/arrange.hpp"

#include "host/scene_text/arrange/depth.hpp"
#include "host/scene_text/arrange/folding.hpp"
#include "host/scene_text/arrange/line_pens.hpp"
#include "host/scene_text/arrange/paints.hpp"
#include "host/scene_text/arrange/ranges.hpp"
#include "host/scene_text/arrange/skewing.hpp"
#include "host/scene_text/arrange/unseen.hpp"

namespace kfast::scene_text {

Reach arrange(std::vector<art::Node>& nodes, const Arranging& arranging)
{
    join_parts(nodes);
    drop_unseen(nodes, arranging.length);
    report_bent_pens(nodes, arranging.losses);
    part_paints(nodes, arranging.length);
    fold(nodes);
    straighten(nodes, arranging);
    fold(nodes);
    Reach reach;
    reach.left_alone = fit_ranges(nodes);
    limit_depth(nodes, arranging);
    reach.in_groups = hold_in_ranges(nodes, arranging.losses);
    return reach;
}

}
