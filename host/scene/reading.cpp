#include "host/scene/reading.hpp"

#include <utility>

namespace kfast::scene {

bool Report::error(Place place, std::string message, std::string remedy)
{
    if (++errors_ <= most_errors)
        diagnostics_.error(place, std::move(message), std::move(remedy));
    else if (errors_ == most_errors + 1)
        diagnostics_.error(place, "too many errors; what follows was not checked");
    return false;
}

void Report::warning(Place place, std::string message, std::string remedy)
{
    if (++warnings_ <= most_warnings)
        diagnostics_.warning(place, std::move(message), std::move(remedy));
    else if (warnings_ == most_warnings + 1)
        diagnostics_.warning(place, "too many warnings; the others are not shown");
}

std::string Report::line(Place place) const
{
    return "line " + std::to_string(line_column(source_.text, place.offset).line);
}

}
