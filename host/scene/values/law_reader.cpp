#include "host/scene/values/law_reader.hpp"

#include "host/geometry/path_scanner.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/expression.hpp"
#include "host/schema/variable_names.hpp"
#include "host/text/characters.hpp"
#include "host/words/law_words.hpp"
#include "host/words/synonyms.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace kfast::scene {

namespace {

struct Parameter {
    std::string_view name;
    Range range;
};

constexpr Range control_x{0, 1};
constexpr Range control_y{double{VelocityLaw::lowest_y} / VelocityLaw::control_one,
                          double{VelocityLaw::highest_y} / VelocityLaw::control_one};
constexpr std::array step_parameters{Parameter{"n", {1, std::numeric_limits<std::uint16_t>::max()}}};
constexpr std::array bezier_parameters{Parameter{"x1", control_x}, Parameter{"y1", control_y},
                                       Parameter{"x2", control_x}, Parameter{"y2", control_y}};

/// A law with numbers in parentheses.
struct CallForm {
    const LawWord& word;
    std::span<const Parameter> parameters;
    bool whole_numbers;
    VelocityLaw (*make)(std::span<const double> numbers);
};

constexpr std::array calls{
    CallForm{
        word_of(VelocityLaw::Kind::steps), step_parameters, true,
        [](std::span<const double> n) { return VelocityLaw::in_steps(static_cast<std::uint16_t>(n[0])); }},
    CallForm{word_of(VelocityLaw::Kind::bezier), bezier_parameters, false,
             [](std::span<const double> n) { return bezier_law(n[0], n[1], n[2], n[3]); }},
};

constexpr auto law_names = [] {
    std::array<std::string_view, law_words.size()> names;
    std::ranges::transform(law_words, names.begin(), &LawWord::keyword);
    return names;
}();

const CallForm& form_of(const LawWord& word)
{
    return *std::ranges::find(calls, &word, [](const CallForm& call) { return &call.word; });
}

std::string hint_for(std::string_view form) { return "write \"" + std::string{form} + "\""; }

std::string count_of_numbers(const CallForm& call)
{
    const std::size_t count = call.parameters.size();
    return std::string{call.word.keyword} + " takes " +
           (count == 1 ? "one number" : std::to_string(count) + " numbers");
}

class LawReader {
public:
    LawReader(const kdl::Value& value, std::string_view text, Report& report)
        : scanner_{text}, text_{text}, value_{value}, report_{report}
    {
    }

    std::optional<VelocityLaw> read();

private:
    std::optional<VelocityLaw> read_call(const CallForm& call);
    std::optional<double> read_number(const CallForm& call, const Parameter& parameter);
    bool at_expression();
    std::optional<double> read_expression();
    bool expect(char mark, const CallForm& call);
    bool expect_end(std::string_view form);

    std::string_view take_name();
    /// The byte after white space, 0 at the end.
    char next();

    /// Reports the text from `begin` to the scanner's position, or the byte there. Always false.
    bool fail(std::size_t begin, std::string message, std::string hint);

    PathScanner scanner_; ///< numbers are written as in paths
    std::string_view text_;
    const kdl::Value& value_;
    Report& report_;
};

std::optional<VelocityLaw> LawReader::read()
{
    scanner_.skip_space();
    const std::size_t begin = scanner_.offset();
    const std::string_view name = take_name();
    const auto word = std::ranges::find(law_words, name, &LawWord::keyword);
    if (word == law_words.end())
        fail(begin, "unknown law " + in_quotes(name), word_hint(name, law_names));
    else if (word->has_numbers())
        return read_call(form_of(*word));
    else if (expect_end(name))
        return word->law;
    return std::nullopt;
}

std::optional<VelocityLaw> LawReader::read_call(const CallForm& call)
{
    std::vector<double> numbers;
    for (const Parameter& parameter : call.parameters) {
        if (!expect(numbers.empty() ? '(' : ',', call))
            return std::nullopt;
        const auto number = read_number(call, parameter);
        if (!number)
            return std::nullopt;
        numbers.push_back(*number);
    }
    if (!expect(')', call) || !expect_end(call.word.form))
        return std::nullopt;
    return call.make(numbers);
}

std::optional<double> LawReader::read_number(const CallForm& call, const Parameter& parameter)
{
    const bool is_missing = next() == ')';
    const std::size_t begin = scanner_.offset();
    const bool is_expression = at_expression();
    const bool is_number = is_expression || scanner_.at_number();
    const auto number = is_expression ? read_expression() : scanner_.number();
    const std::string name{parameter.name};
    if (is_expression && !number)
        return number;
    if (is_missing)
        fail(begin, count_of_numbers(call), hint_for(call.word.form));
    else if (!is_number)
        fail(begin, "a number is expected here", hint_for(call.word.form));
    else if (!number || *number < parameter.range.low || *number > parameter.range.high)
        fail(begin, name + " is out of range", allowed(parameter.range));
    else if (call.whole_numbers && std::trunc(*number) != *number)
        fail(begin, name + " must be a whole number", allowed(parameter.range));
    else
        return number;
    return std::nullopt;
}

/// Whether it is more than a number, which may have a + in front.
bool LawReader::at_expression()
{
    if (report_.variables() == nullptr)
        return false;
    PathScanner ahead = scanner_;
    const bool is_number = ahead.number().has_value();
    ahead.skip_space();
    const std::string_view rest = text_.substr(ahead.offset());
    if (is_number)
        return !rest.empty() && std::string_view{"+-*/"}.find(rest.front()) != std::string_view::npos;
    const std::string_view word = schema::name_in_front(rest);
    if (word.empty())
        return rest.starts_with('(') || rest.starts_with('-');
    return !report_.variables()->empty() || !schema::is_variable_name(word);
}

std::optional<double> LawReader::read_expression()
{
    const auto found = schema::evaluate_front(text_, scanner_.offset(), *report_.variables());
    while (scanner_.offset() < found.end)
        scanner_.take();
    if (found.finding)
        pass_on(*found.finding, value_, "law", report_);
    return found.value;
}

/// What is in the place of `mark` determines the report.
bool LawReader::expect(char mark, const CallForm& call)
{
    const char found = next();
    if (found == mark) {
        scanner_.take();
        return true;
    }
    if (mark == '(' || found == ')' || found == ',')
        return fail(mark == '(' ? 0 : scanner_.offset(), count_of_numbers(call), hint_for(call.word.form));
    return fail(scanner_.offset(), in_quotes({&mark, 1}) + " is expected here", hint_for(call.word.form));
}

bool LawReader::expect_end(std::string_view form)
{
    if (next() == '\0' && scanner_.at_end())
        return true;
    const std::size_t begin = scanner_.offset();
    while (!scanner_.at_end())
        scanner_.take();
    return fail(begin, "this is too much for a law", hint_for(form));
}

std::string_view LawReader::take_name()
{
    const std::size_t begin = scanner_.offset();
    const std::size_t end = std::min(text_.find_first_of("( \t\r\n\f", begin), text_.size());
    while (scanner_.offset() < end)
        scanner_.take();
    return text_.substr(begin, end - begin);
}

char LawReader::next()
{
    scanner_.skip_space();
    return scanner_.at_end() ? '\0' : text_[scanner_.offset()];
}

bool LawReader::fail(std::size_t begin, std::string message, std::string hint)
{
    const std::size_t min = begin < text_.size() ? 1 : 0;
    const SourceSpan place{begin, std::max(scanner_.offset() - begin, min)};
    pass_on({Severity::error, place, std::move(message), std::move(hint)}, value_, "law", report_);
    return false;
}

}

std::optional<VelocityLaw> read_law(const kdl::Value& value, Report& report)
{
    const auto text = read_text(value, report);
    return text ? LawReader{value, *text, report}.read() : std::nullopt;
}

std::vector<std::string_view> law_forms()
{
    std::vector<std::string_view> forms;
    std::ranges::transform(law_words, std::back_inserter(forms), &LawWord::form);
    return forms;
}

}
