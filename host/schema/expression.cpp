#include "host/schema/expression.hpp"

#include "host/schema/arithmetic.hpp"
#include "host/schema/expression_slips.hpp"
#include "host/schema/variable_names.hpp"
#include "host/text/characters.hpp"
#include "host/text/suggestion.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <system_error>
#include <utility>

namespace kfast::schema {

namespace {

class ExpressionReader {
public:
    ExpressionReader(std::string_view text, std::size_t begin, Variables& variables)
        : text_{text}, begin_{begin}, offset_{begin}, variables_{variables}
    {
    }

    Evaluation read(bool is_whole);

private:
    using Number = std::optional<double>;

    Number chain(int min_precedence);
    Number operand();
    template <class Read>
    Number deeper(Read read);
    Number negated();
    Number group();
    Number literal();
    Number named();
    Number called(const Function& function, SourceSpan name);
    Number value_of(std::string_view name, SourceSpan place);

    const Operator* operator_ahead(int min_precedence);
    Number combined(double left, const Operator& with, double right, std::size_t begin, std::size_t middle);
    Number within_limits(double number, std::size_t begin);

    char next();
    bool accept(char mark);
    SourceSpan since(std::size_t begin) const { return {begin, offset_ - begin}; }
    /// What stands here: a word, or a character.
    SourceSpan token() const;
    Number misplaced();
    Number fail(SourceSpan place, std::string message, std::string hint);

    std::string_view text_;
    std::size_t begin_;
    std::size_t offset_;
    int depth_ = 0;
    Variables& variables_;
    Evaluation result_;
};

Evaluation ExpressionReader::read(bool is_whole)
{
    const std::size_t rest = text_.size() - begin_;
    Number number;
    if (rest > longest_expression)
        fail({begin_, rest}, "this expression is too long",
             "it has at most " + std::to_string(longest_expression) +
                 " bytes; give parts of it a name: let part=…");
    else
        number = chain(0);
    next();
    if (number && is_whole && offset_ < text_.size())
        number = misplaced();
    if (number)
        result_.value = on_grid(*number);
    result_.end = offset_;
    return std::move(result_);
}

template <class Read>
std::optional<double> ExpressionReader::deeper(Read read)
{
    if (depth_ == deepest_expression)
        return fail(token(), "this expression is nested too deep",
                    "at most " + std::to_string(deepest_expression) +
                        " levels; give parts of it a name: let part=…");
    ++depth_;
    const Number number = read();
    --depth_;
    return number;
}

/// Operators of at least that precedence, from left to right.
std::optional<double> ExpressionReader::chain(int min_precedence)
{
    next();
    const std::size_t begin = offset_;
    Number left = operand();
    while (left) {
        const Operator* const with = operator_ahead(min_precedence);
        if (with == nullptr)
            break;
        ++offset_;
        next();
        const std::size_t middle = offset_;
        const Number right = chain(with->precedence + 1);
        left = right ? combined(*left, *with, *right, begin, middle) : std::nullopt;
    }
    return left;
}

std::optional<double> ExpressionReader::operand()
{
    const char first = next();
    if (first == '-')
        return deeper([this] { return negated(); });
    if (first == '(')
        return deeper([this] { return group(); });
    if (begins_name(first))
        return named();
    if (is_digit(first) || first == '.')
        return literal();
    if (first == '\0' || first == ')' || first == ',')
        return fail(token(), "a value is missing here", "write a number, a variable or (…)");
    return misplaced();
}

std::optional<double> ExpressionReader::negated()
{
    ++offset_;
    const Number number = operand();
    return number ? Number{-*number} : number;
}

std::optional<double> ExpressionReader::group()
{
    const SourceSpan opening{offset_++, 1};
    const Number number = chain(0);
    if (!number || accept(')'))
        return number;
    return next() == '\0' ? fail(opening, "this ( is not closed", "add a )") : misplaced();
}

std::optional<double> ExpressionReader::literal()
{
    const std::size_t begin = offset_;
    double number = 0;
    const auto [end, failure] = std::from_chars(text_.data() + begin, text_.data() + text_.size(), number);
    if (failure == std::errc::invalid_argument)
        return misplaced();
    offset_ = static_cast<std::size_t>(end - text_.data());
    if (failure == std::errc{})
        return within_limits(number, begin);
    return fail(since(begin), "this number is too large, or too close to 0", {});
}

std::optional<double> ExpressionReader::named()
{
    const std::size_t begin = offset_;
    offset_ = name_end(text_, begin);
    const SourceSpan place = since(begin);
    const std::string_view name = text_.substr(begin, place.length);
    const Function* const function = function_called(name);
    if (function != nullptr)
        return deeper([&] { return called(*function, place); });
    if (next() != '(')
        return value_of(name, place);
    std::array<std::string_view, functions.size()> known;
    std::ranges::transform(functions, known.begin(), &Function::name);
    return fail(place, "unknown function " + in_quotes(name), suggestion(name, known));
}

std::optional<double> ExpressionReader::called(const Function& function, SourceSpan name)
{
    const std::string hint = "write " + std::string{function.usage};
    if (!accept('('))
        return fail(name, std::string{function.name} + " is a function", hint);
    std::vector<double> values;
    do {
        const Number value = chain(0);
        if (!value)
            return value;
        values.push_back(*value);
    } while (accept(','));
    if (next() == '\0')
        return fail(name, "the ( of this function is not closed", "add a )");
    if (!accept(')'))
        return misplaced();
    if (values.size() < function.least || values.size() > function.most)
        return fail(since(name.offset),
                    std::string{function.name} + " takes " +
                        (function.least == 1 ? "one value" : "two values or more"),
                    hint);
    return within_limits(function.compute(values), name.offset);
}

std::optional<double> ExpressionReader::value_of(std::string_view name, SourceSpan place)
{
    Variable* const variable = variables_.find(name);
    if (variable == nullptr) {
        const std::string close = did_you_mean(name, variables_.names());
        return fail(place, "a number is expected here, and there is no variable " + in_quotes(name),
                    close.empty() ? "define it: let " + visible(name) + "=…" : close);
    }
    variable->is_used = true;
    if (variable->is_defined)
        return variable->value;
    result_.too_early = variable;
    return fail(place, in_quotes(name) + " is used before its definition", "define it in front of this");
}

const Operator* ExpressionReader::operator_ahead(int min_precedence)
{
    const auto found = std::ranges::find(operators, next(), &Operator::mark);
    return found != operators.end() && found->precedence >= min_precedence ? &*found : nullptr;
}

/// The right side begins at `middle`.
std::optional<double> ExpressionReader::combined(double left, const Operator& with, double right,
                                                 std::size_t begin, std::size_t middle)
{
    if (with.mark == '/' && right == 0)
        return fail(since(middle), "this divides by 0", "let it be something else");
    return within_limits(with.compute(left, right), begin);
}

std::optional<double> ExpressionReader::within_limits(double number, std::size_t begin)
{
    if (std::abs(number) <= largest_number)
        return number;
    return fail(since(begin), "this comes to too large a number", "allowed: -1000000000 to 1000000000");
}

/// The byte behind blanks, 0 at the end.
char ExpressionReader::next()
{
    while (offset_ < text_.size() &&
           std::string_view{" \t\r\n"}.find(text_[offset_]) != std::string_view::npos)
        ++offset_;
    return offset_ < text_.size() ? text_[offset_] : '\0';
}

bool ExpressionReader::accept(char mark)
{
    const bool is_there = next() == mark;
    offset_ += is_there ? 1 : 0;
    return is_there;
}

SourceSpan ExpressionReader::token() const
{
    if (offset_ >= text_.size())
        return {text_.size(), 0};
    const std::size_t word = name_end(text_, offset_) - offset_;
    return {offset_, word > 0 ? word : code_point_at(text_, offset_).length};
}

std::optional<double> ExpressionReader::misplaced()
{
    const SourceSpan place = token();
    const std::string_view written = text_.substr(place.offset, place.length);
    return fail(place, in_quotes(written) + " cannot stand here", hint_of_misplaced(written));
}

std::optional<double> ExpressionReader::fail(SourceSpan place, std::string message, std::string hint)
{
    result_.finding = {Severity::error, place, std::move(message), std::move(hint)};
    return std::nullopt;
}

}

Evaluation evaluate(std::string_view text, Variables& variables)
{
    const std::size_t first = std::min(text.find_first_not_of(" \t\r\n"), text.size());
    const bool has_mark = first < text.size() && text[first] == '=';
    return ExpressionReader{text, has_mark ? first + 1 : first, variables}.read(true);
}

Evaluation evaluate_front(std::string_view text, std::size_t begin, Variables& variables)
{
    return ExpressionReader{text, begin, variables}.read(false);
}

}
