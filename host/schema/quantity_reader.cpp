#include "host/schema/quantity_reader.hpp"

#include "host/text/glyph.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace kfast::schema {
namespace {

const QuantityUnit* unit_of(const kdl::Value& value, const QuantityForm& form, Report& report)
{
    if (!value.type) {
        report.error(value.place, std::string{form.noun} + " needs a unit",
                     "write it like " + std::string{form.example});
        return nullptr;
    }
    const auto unit = std::ranges::find(form.units, *value.type, &QuantityUnit::name);
    if (unit != form.units.end())
        return &*unit;
    std::vector<std::string_view> known;
    std::ranges::transform(form.units, std::back_inserter(known), &QuantityUnit::name);
    report.error(value.place, "unknown unit " + in_quotes(*value.type), suggestion(*value.type, known));
    return nullptr;
}

}

std::string quantity_text(double quantity, const QuantityForm& form)
{
    const auto value_in = [quantity](const QuantityUnit& unit) { return quantity / unit.factor; };
    const auto best = std::ranges::min_element(form.units, {}, [&](const QuantityUnit& unit) {
        return value_in(unit) >= 1 ? value_in(unit) : std::numeric_limits<double>::max();
    });
    return '(' + std::string{best->name} + ')' + text_of(value_in(*best));
}

std::optional<double> read_quantity(const kdl::Value& value, const QuantityForm& form, Range range,
                                    Report& report)
{
    const kdl::Number* const number = value.number();
    if (number == nullptr) {
        report.error(value.place, std::string{form.noun} + " is expected here",
                     "write it like " + std::string{form.example});
        return std::nullopt;
    }
    const QuantityUnit* const unit = unit_of(value, form, report);
    if (unit == nullptr)
        return std::nullopt;
    const double quantity = number->value * unit->factor;
    if (quantity >= range.low && quantity <= range.high)
        return quantity;
    report.error(value.place, "this number is out of range",
                 "allowed: " + quantity_text(range.low, form) + " to " + quantity_text(range.high, form));
    return std::nullopt;
}

}
