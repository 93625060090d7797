#include "host/text/suggestion.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace kfast {
namespace {

constexpr std::size_t longest_name = 40;
constexpr std::size_t longest_list = 40;

/// Insertions, deletions, replacements and swaps of neighbours that turn `a` into `b`, in bytes (the optimal
/// string alignment distance). Row by row; a swap looks back two rows.
std::size_t edit_distance(std::string_view a, std::string_view b)
{
    std::vector<std::size_t> before_last(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
        row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before_last.swap(last);
        last.swap(row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before_last[j - 2] + 1);
        }
    }
    return row[b.size()];
}

/// A third of the letters may be wrong, but never all of them. Leading dashes do not count.
std::size_t tolerance(std::string_view name)
{
    const std::size_t letters = name.size() - std::min(name.find_first_not_of('-'), name.size());
    return letters < 2 ? 0 : std::max<std::size_t>(1, letters / 3);
}

std::string_view closest(std::string_view name, std::span<const std::string_view> known)
{
    std::string_view best;
    std::size_t best_distance = tolerance(name) + 1;
    for (const std::string_view candidate : known) {
        if (candidate.size() > longest_name)
            continue;
        const std::size_t distance = edit_distance(name, candidate);
        if (distance < best_distance) {
            best = candidate;
            best_distance = distance;
        }
    }
    return best;
}

std::string list(std::span<const std::string_view> known)
{
    std::string text = known.empty() ? "nothing is allowed here" : "allowed:";
    for (const std::string_view name : known.first(std::min(known.size(), longest_list)))
        text.append(text.back() == ':' ? " " : ", ").append(name);
    return known.size() > longest_list ? text + ", …" : text;
}

}

std::string did_you_mean(std::string_view name, std::span<const std::string_view> known)
{
    const std::string_view best = name.size() > longest_name ? std::string_view{} : closest(name, known);
    return best.empty() ? std::string{} : "did you mean \"" + std::string{best} + "\"?";
}

std::string suggestion(std::string_view name, std::span<const std::string_view> known)
{
    const std::string close = did_you_mean(name, known);
    return close.empty() ? list(known) : close;
}

}
