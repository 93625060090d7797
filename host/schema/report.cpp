#include "host/schema/report.hpp"

#include "host/text/characters.hpp"

#include <utility>

namespace kfast::schema {

bool Report::error(SourceSpan place, std::string message, std::string hint)
{
    if (++errors_ <= max_errors)
        diagnostics_.error(place, std::move(message), std::move(hint));
    else if (errors_ == max_errors + 1)
        diagnostics_.error(place, "too many errors; what follows was not checked");
    return false;
}

void Report::warning(SourceSpan place, std::string message, std::string hint)
{
    if (++warnings_ <= max_warnings)
        diagnostics_.warning(place, std::move(message), std::move(hint));
    else if (warnings_ == max_warnings + 1)
        diagnostics_.warning(place, "too many warnings; the others are not shown");
}

std::string Report::line(SourceSpan place) const
{
    return "line " + std::to_string(line_column(source_.text, place.offset).line);
}

bool add_name(NameTable& names, std::string_view noun, std::string_view name, SourceSpan place,
              Report& report)
{
    const auto earlier = names.add(name, place);
    return !earlier || report_duplicate(noun, name, place, *earlier, report);
}

bool report_duplicate(std::string_view noun, std::string_view name, SourceSpan place, SourceSpan earlier,
                      Report& report)
{
    return report.error(place, "there is " + std::string{noun} + ' ' + in_quotes(name) + " already, on " +
                                   report.line(earlier));
}

}
