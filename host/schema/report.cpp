#include "host/schema/report.hpp"

#include "host/text/glyph.hpp"

#include <utility>

namespace kfast::schema {

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

bool add_name(NameTable& names, std::string_view noun, std::string_view name, Place place, Report& report)
{
    const auto earlier = names.add(name, place);
    return !earlier || report_double(noun, name, place, *earlier, report);
}

bool report_double(std::string_view noun, std::string_view name, Place place, Place earlier, Report& report)
{
    return report.error(place, "there is " + std::string{noun} + ' ' + in_quotes(name) + " already, on " +
                                   report.line(earlier));
}

}
