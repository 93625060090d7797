#include "host/scene_text/arrange/spans.hpp"

#include <algorithm>

namespace kfast::scene_text {

using art::Span;

std::vector<Span> common(const std::vector<Span>& one, const std::vector<Span>& other)
{
    std::vector<Span> both;
    for (const Span& left : one)
        for (const Span& right : other)
            if (const Span span{std::max(left.from, right.from), std::min(left.to, right.to)};
                span.from < span.to)
                both.push_back(span);
    std::ranges::sort(both, {}, &Span::from);
    return both;
}

}
