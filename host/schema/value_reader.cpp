#include "host/schema/value_reader.hpp"

#include "host/kdl/number.hpp"
#include "host/kdl/scalar.hpp"
#include "host/schema/variable_names.hpp"
#include "host/text/characters.hpp"
#include "host/words/synonyms.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace kfast::schema {

namespace {

/// The hint if a text was meant as a number; else empty.
std::string hint_of_text(const std::string& text)
{
    constexpr std::string_view minus = "\u2212";
    const bool is_typographic = text.starts_with(minus);
    const std::string plain = is_typographic ? '-' + text.substr(minus.size()) : text;
    if (!kdl::begins_like_number(plain) || !std::holds_alternative<kdl::Number>(kdl::number_from(plain)))
        return {};
    return "write " + plain + (is_typographic ? ", with the minus of the keyboard" : " without quotes");
}

/// A type annotation is allowed on times only.
bool without_type(const kdl::Value& value, Report& report)
{
    return !value.type || report.error(value.place, "this value takes no type or unit",
                                       "leave out (" + visible(*value.type) + ")");
}

bool is_control(char letter)
{
    const auto code = static_cast<unsigned char>(letter);
    return code < 0x20 || code == 0x7F;
}

}

std::string text_of(double number)
{
    std::array<char, 32> digits;
    return {
        digits.data(),
        std::to_chars(digits.data(), digits.data() + digits.size(), number, std::chars_format::fixed).ptr};
}

std::string allowed(Range range) { return "allowed: " + text_of(range.low) + " to " + text_of(range.high); }

bool is_expression(const kdl::Value& value, const Report& report)
{
    const std::string* const text = value.string();
    if (text == nullptr || report.variables() == nullptr || text->find_first_not_of(' ') == text->npos)
        return false;
    const bool is_slip = report.variables()->empty() && is_variable_name(*text);
    return !is_slip && hint_of_text(*text).empty();
}

namespace {

bool is_without_quotes(const kdl::Value& value)
{
    return value.text_offset &&
           *value.text_offset + value.string()->size() == value.place.offset + value.place.length;
}

}

std::optional<double> result_of(const Evaluation& found, const kdl::Value& value, Report& report)
{
    if (!found.finding)
        return found.value;
    Diagnostic finding = *found.finding;
    if (finding.place.offset == value.string()->size() && is_without_quotes(value))
        finding.hint += "; what has blanks in it stands in quotes";
    pass_on(finding, value, "expression", report);
    return std::nullopt;
}

std::optional<double> number_of(const kdl::Value& value, Report& report)
{
    if (const kdl::Number* const number = value.number())
        return number->value;
    const std::string* const text = value.string();
    if (is_expression(value, report))
        return result_of(evaluate(*text, *report.variables()), value, report);
    report.error(value.place, "a number is expected here",
                 text == nullptr ? std::string{} : hint_of_text(*text));
    return std::nullopt;
}

namespace {

/// Of an expression, what it comes to.
std::string comes_to(const kdl::Value& value, double number)
{
    return value.string() == nullptr ? std::string{} : ": it comes to " + text_of(number);
}

}

std::optional<double> read_number(const kdl::Value& value, Range range, Report& report)
{
    const auto number = number_of(value, report);
    if (!number || !without_type(value, report))
        return std::nullopt;
    if (*number >= range.low && *number <= range.high)
        return number;
    report.error(value.place, "this number is out of range" + comes_to(value, *number), allowed(range));
    return std::nullopt;
}

void report_out_of_range(const kdl::Value& value, Range range, Report& report)
{
    report.error(value.place, "this number is out of range", allowed(range));
}

std::optional<std::vector<double>> read_numbers(std::span<const kdl::Value> values,
                                                std::span<const Range> ranges, Report& report)
{
    std::vector<double> numbers;
    for (const kdl::Value& value : values) {
        const std::size_t place = std::min(numbers.size(), ranges.size() - 1);
        const auto number = read_number(value, ranges[place], report);
        if (!number)
            return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

std::optional<int> read_whole_number(const kdl::Value& value, Range range, Report& report)
{
    const auto number = read_number(value, range, report);
    if (!number)
        return std::nullopt;
    if (std::trunc(*number) == *number)
        return static_cast<int>(*number);
    report.error(value.place, "a whole number is expected here" + comes_to(value, *number),
                 value.string() == nullptr ? std::string{} : "write \"round(…)\"");
    return std::nullopt;
}

std::optional<bool> read_flag(const kdl::Value& value, Report& report)
{
    const bool* const flag = std::get_if<bool>(&value.data);
    if (flag == nullptr)
        report.error(value.place, "#true or #false is expected here");
    if (flag == nullptr || !without_type(value, report))
        return std::nullopt;
    return *flag;
}

std::optional<std::string_view> read_text(const kdl::Value& value, Report& report)
{
    const std::string* const text = value.string();
    if (text == nullptr)
        report.error(value.place, "a word or a text in quotes is expected here");
    if (text == nullptr || !without_type(value, report))
        return std::nullopt;
    return *text;
}

std::optional<std::string_view> read_name(const kdl::Value& value, Report& report)
{
    const auto name = read_text(value, report);
    if (!name)
        return std::nullopt;
    if (name->empty())
        report.error(value.place, "a name cannot be empty");
    else if (name->size() > max_name_bytes)
        report.error(value.place, "this name is too long",
                     "a name has at most " + std::to_string(max_name_bytes) + " bytes");
    else if (std::ranges::any_of(*name, is_control)) // boards write names into lines of text
        report.error(value.place, "a name has no line ends or other control characters");
    else
        return name;
    return std::nullopt;
}

void report_unknown_word(const kdl::Value& value, std::string_view name,
                         std::span<const std::string_view> known, Report& report)
{
    report.error(value.place, "unknown value " + in_quotes(name), word_hint(name, known));
}

void pass_on(const Diagnostic& finding, const kdl::Value& value, std::string_view what, Report& report)
{
    SourceSpan place = value.place;
    std::string message = finding.message;
    if (value.text_offset) {
        place = {*value.text_offset + finding.place.offset, finding.place.length};
    } else {
        const LineColumn at = line_column(*value.string(), finding.place.offset);
        message += " (line " + std::to_string(at.line) + ", column " + std::to_string(at.column) +
                   " of the " + std::string{what} + ")";
    }
    if (finding.severity == Severity::error)
        report.error(place, message, finding.hint);
    else
        report.warning(place, message, finding.hint);
}

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
