#include "host/scene/values/law_reader.hpp"

#include "host/geometry/path_scanner.hpp"
#include "host/scene/values/law_calls.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/expression.hpp"
#include "host/schema/variable_names.hpp"
#include "host/text/characters.hpp"
#include "host/words/easing_names.hpp"
#include "host/words/law_words.hpp"
#include "host/words/synonyms.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace kfast::scene {

namespace {

constexpr auto law_names = [] {
    std::array<std::string_view, law_words.size()> names;
    std::ranges::transform(law_words, names.begin(), &LawWord::keyword);
    return names;
}();

std::string hint_for(std::string_view form) { return "write \"" + std::string{form} + "\""; }

std::string count_of_numbers(const CallForm& call)
{
    const std::size_t count = call.parameters.size();
    return std::string{call.keyword} + " takes " +
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
    std::optional<VelocityLaw> read_rest(const LawWord& word);
    std::optional<VelocityLaw> read_call(const CallForm& call);
    bool read_jump();
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
    const std::string_view law = law_of_easing(name);
    if (law.empty())
        fail(begin, "unknown law " + in_quotes(name), word_hint(name, law_names));
    else if (law.find('(') == std::string_view::npos)
        return read_rest(word_called(law));
    else if (expect_end(name))
        return LawReader{value_, law, report_}.read();
    return std::nullopt;
}

std::optional<VelocityLaw> LawReader::read_rest(const LawWord& word)
{
    if (!word.has_numbers())
        return expect_end(word.form) ? std::optional{word.law} : std::nullopt;
    const CallForm& call = call_of(word.keyword);
    if (!call.has_default_numbers() || next() == '(')
        return read_call(call);
    return expect_end(word.form) ? std::optional{call.default_law()} : std::nullopt;
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
    if (call.keyword == "steps" && next() == ',' && !read_jump())
        return std::nullopt;
    if (!expect(')', call) || !expect_end(word_called(call.keyword).form))
        return std::nullopt;
    if (const auto objection = call.objection != nullptr ? call.objection(numbers) : std::nullopt) {
        fail(0, objection->message, objection->hint);
        return std::nullopt;
    }
    return call.make(numbers);
}

/// Where the steps of CSS jump: only one of the ways is there.
bool LawReader::read_jump()
{
    scanner_.take();
    scanner_.skip_space();
    const std::size_t begin = scanner_.offset();
    const std::size_t end = std::min(text_.find_first_of(",) \t\r\n\f", begin), text_.size());
    while (scanner_.offset() < end)
        scanner_.take();
    const std::string_view jump = text_.substr(begin, end - begin);
    if (jump == "end" || jump == "jump-end")
        return true;
    if (jump == "start" || jump == "jump-start")
        return fail(begin, "each step jumps at its end",
                    "write \"steps(n)\", and put this key and the next one step earlier");
    return fail(begin, "each step jumps at its end", hint_for("steps(n)"));
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
        fail(begin, count_of_numbers(call), hint_for(word_called(call.keyword).form));
    else if (!is_number)
        fail(begin, "a number is expected here", hint_for(word_called(call.keyword).form));
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
        return fail(mark == '(' ? 0 : scanner_.offset(), count_of_numbers(call),
                    hint_for(word_called(call.keyword).form));
    return fail(scanner_.offset(), in_quotes({&mark, 1}) + " is expected here",
                hint_for(word_called(call.keyword).form));
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
    for (const LawWord& word : law_words) {
        if (word.has_numbers() && call_of(word.keyword).has_default_numbers())
            forms.push_back(word.keyword);
        forms.push_back(word.form);
    }
    return forms;
}

}
