#pragma once

#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"

#include <cstdint>
#include <vector>

namespace kfast::scene_text {

/// Puts transforms that stand still into what they act on, wherever that looks the same: into points, widths
/// and places, or into transforms below. Groups that then do nothing vanish unless they have a name and more
/// than one node; a group with one node becomes that node if one item can do what both do.
void fold(std::vector<art::Node>& nodes);

/// Makes fills and lines such as objects have: opacities that change become those of nodes, and what one
/// object cannot say of a fill and a line becomes two. The scene is `length` ticks long.
void part_paints(std::vector<art::Node>& nodes, std::int32_t length);

/// Leaves out what is never seen in a scene of that many ticks: fills and lines without opacity or width,
/// shapes without drawings, groups without nodes.
void drop_unseen(std::vector<art::Node>& nodes, std::int32_t length);

/// Makes neighbours that are written as one group in several parts one group.
void join_parts(std::vector<art::Node>& nodes);

/// Lets numbers lie within what scenes have: what is drawn too large is drawn smaller and grows, what is
/// drawn too small for its growth is drawn larger, and what goes too far goes in a group that grows. Returns
/// the greatest coordinate, in pixels, that there would be without such groups.
double fit_ranges(std::vector<art::Node>& nodes);

/// Likewise without groups. What is still beyond is held there when it is written, which is a loss. Returns
/// the greatest coordinate that there would be otherwise.
double hold_in_ranges(std::vector<art::Node>& nodes, art::Losses& losses);

}
