#pragma once

#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"

#include <cstdint>
#include <vector>

namespace kfast::scene_text {

struct Arranging;

/// Folds constant transforms into what they act on, wherever that looks the same: into points, widths and
/// positions, or into transforms below. Groups that then do nothing vanish unless they have a name and more
/// than one node; a group with one node becomes that node if one item can do what both do.
void fold(std::vector<art::Node>& nodes);

/// Makes fills and lines such as objects have: opacities that change become those of nodes, and a fill and a
/// line that one object cannot have together become two. The scene is `length` ticks long.
void part_paints(std::vector<art::Node>& nodes, std::int32_t length);

/// Leaves out what is never visible: fills and lines without opacity or width, shapes without drawings,
/// groups without nodes, uses of symbols that draw nothing.
void drop_unseen(std::vector<art::Node>& nodes, const Arranging& arranging);

/// Draws symbols larger that are used in large, and scales their uses down: so fine are their coordinates.
void draw_symbols_larger(art::Document& document);

/// Lets uses that stand still grow and turn about the middle of what they draw, if that is far from their (0,
/// 0): there one sees how scales and rotations are rounded.
void centre_uses(std::vector<art::Node>& nodes, const Arranging& arranging);

/// Makes neighbours that are written as one group in several parts one group.
void join_parts(std::vector<art::Node>& nodes);

/// Takes whole periods away from an offset of dashes that is out of range, if their lengths stand still: it
/// jumps wherever more has come together. One that goes on for too long is left as it is.
void reduce_offset(art::Dashes& dashes);

/// Brings numbers into the ranges of scenes: what is drawn too large is drawn smaller and scaled up, what is
/// drawn too small for its scale is drawn larger, and what moves too far moves in a group that is scaled up.
/// Returns the greatest coordinate, in pixels, that there would be without such groups.
double fit_ranges(std::vector<art::Node>& nodes);

/// The same without groups. What is still out of range is clamped when it is written, which is a loss.
/// Returns the greatest coordinate that there would be otherwise.
double hold_in_ranges(std::vector<art::Node>& nodes, art::Losses& losses);

}
