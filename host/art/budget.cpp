#include "host/art/budget.hpp"

#include "host/program/failure.hpp"

namespace kfast::art {
namespace {

void take(std::size_t& taken, std::size_t count, std::size_t max, const char* noun)
{
    if (count > max - taken)
        throw Failure("more than " + std::to_string(max) + ' ' + noun +
                      ", parts counted wherever they are used: take something out of the file");
    taken += count;
}

}

void Budget::take_node() { take(nodes_, 1, max_nodes, "layers, groups and shapes"); }
void Budget::take_points(std::size_t count) { take(points_, count, max_points, "points in all keys"); }
void Budget::take_keys(std::size_t count) { take(keys_, count, max_keys, "keys"); }
void Budget::take_computed_points(std::size_t count)
{
    take(computed_points_, count, max_computed_points, "points to compute for what moves");
}

void Budget::check_depth(int depth)
{
    if (depth > deepest)
        throw Failure("layers and groups lie more than " + std::to_string(deepest) +
                      " deep in each other, or use themselves: flatten some of them");
}

void Budget::check_parsed(const std::string& file, std::size_t count, const char* noun)
{
    if (count > max_parsed)
        throw Failure(file + ": more than " + std::to_string(max_parsed) + ' ' + noun +
                      ": take something out of the file");
}

}
