#include "host/schema/expression.hpp"
#include "host/schema/variable_names.hpp"

#include <doctest/doctest.h>

#include <string>

namespace kfast::test {

using namespace schema;

namespace {

Variables some_variables()
{
    Variables variables;
    const auto add = [&variables](const char* name, std::optional<double> value, bool is_defined = true) {
        variables.add(
            {.name = name, .place = {}, .definition = nullptr, .is_defined = is_defined, .value = value});
    };
    add("size", 20);
    add("x_2", -3);
    add("wrong", std::nullopt);
    add("later", std::nullopt, false);
    return variables;
}

double value(std::string_view text)
{
    Variables variables = some_variables();
    const Evaluation found = evaluate(text, variables);
    CAPTURE(text);
    REQUIRE(!found.finding);
    REQUIRE(found.value);
    CHECK(found.end == text.size());
    return *found.value;
}

/// As `place+length message (hint)`.
std::string finding(std::string_view text)
{
    Variables variables = some_variables();
    const Evaluation found = evaluate(text, variables);
    CHECK(!found.value);
    if (!found.finding)
        return "";
    const SourceSpan place = found.finding->place;
    return std::to_string(place.offset) + '+' + std::to_string(place.length) + ' ' + found.finding->message +
           (found.finding->hint.empty() ? "" : " (" + found.finding->hint + ')');
}

const std::string words = " (operators are + - * /, functions min, max, round, sin, cos)";

}

TEST_CASE("operators go from left to right, the strong ones first")
{
    CHECK(value("2+3*4-5") == 9);
    CHECK(value("2-3-4") == -5);
    CHECK(value("24/4/2") == 3);
    CHECK(value("24/4*2") == 12);
    CHECK(value("(2+3)*(4-5)") == -5);
    CHECK(value("1 - 2 * 3 + 4 / 2") == -3);
}

TEST_CASE("a minus turns the sign of what is behind it alone")
{
    CHECK(value("-2*3+1") == -5);
    CHECK(value("2*-3") == -6);
    CHECK(value("2--3") == 5);
    CHECK(value("-(2+3)") == -5);
    CHECK(value("- - -size") == -20);
    CHECK(value("size-2") == 18);
    CHECK(value("size -2") == 18);
}

TEST_CASE("numbers are decimal, with a fraction and an exponent or not")
{
    CHECK(value("12") == 12);
    CHECK(value("0.5") == 0.5);
    CHECK(value(".5") == 0.5);
    CHECK(value("1.5e2") == 150);
    CHECK(value("25E-2") == 0.25);
    CHECK(value("2e3+1") == 2001);
}

TEST_CASE("white space may stand between all parts, a = in front")
{
    CHECK(value("=size") == 20);
    CHECK(value(" = 2 * ( size\t+ 1 ) ") == 42);
    CHECK(value("max ( 1 ,\n 2 )") == 2);
}

TEST_CASE("functions are computed")
{
    CHECK(value("min(3, 1, 2)") == 1);
    CHECK(value("max(3, size, x_2) + 1") == 21);
    CHECK(value("round(2.5)") == 3);
    CHECK(value("round(-2.5)") == -3);
    CHECK(value("10*sin(30)") == 5);
    CHECK(value("cos(60)*size") == 10);
    CHECK(value("min(max(1, 2), round(cos(0) * 7.4))") == 2);
}

TEST_CASE("what is told apart by a double and not by people is the same")
{
    CHECK(value("0.1*3") == 0.3);
    CHECK(value("0.07*100") == 7);
    CHECK(value("1/3*3") == 1);
    CHECK(value("sin(180)") == 0);
}

TEST_CASE("variables that are used are known to be")
{
    Variables variables = some_variables();
    evaluate("2*size", variables);
    CHECK(variables.find("size")->is_used);
    CHECK(!variables.find("x_2")->is_used);
}

TEST_CASE("a variable is there, and defined")
{
    CHECK(finding("2*siz") ==
          "2+3 a number is expected here, and there is no variable \"siz\" (did you mean \"size\"?)");
    CHECK(finding("height/2") ==
          "0+6 a number is expected here, and there is no variable \"height\" (define it: let height=…)");
    CHECK(finding("1+later") == "2+5 \"later\" is used before its definition (define it in front of this)");
    CHECK(finding("wrong+1") == ""); // reported where it is defined
}

TEST_CASE("functions are known, and have as many values as they take")
{
    CHECK(finding("tan(3)") == "0+3 unknown function \"tan\" (allowed: min, max, round, sin, cos)");
    CHECK(finding("rond(3)") == "0+4 unknown function \"rond\" (did you mean \"round\"?)");
    CHECK(finding("1+sin") == "2+3 sin is a function (write sin(DEGREES))");
    CHECK(finding("sin(1, 2)") == "0+9 sin takes one value (write sin(DEGREES))");
    CHECK(finding("2*min(1)") == "2+6 min takes two values or more (write min(A, B))");
    CHECK(finding("min()") == "4+1 a value is missing here (write a number, a variable or (…))");
    CHECK(finding("min(1, 2") == "0+3 the ( of this function is not closed (add a ))");
    CHECK(finding("min(1 2)") == "6+1 \"2\" cannot stand here" + words);
}

TEST_CASE("what is no expression is refused where it begins to be none")
{
    const std::string missing = " a value is missing here (write a number, a variable or (…))";
    CHECK(finding("") == "0+0" + missing);
    CHECK(finding("=") == "1+0" + missing);
    CHECK(finding("2+") == "2+0" + missing);
    CHECK(finding("-") == "1+0" + missing);
    CHECK(finding("()") == "1+1" + missing);
    CHECK(finding("(1+2") == "0+1 this ( is not closed (add a ))");
    CHECK(finding("(1 2)") == "3+1 \"2\" cannot stand here" + words);
    CHECK(finding("1)") == "1+1 \")\" cannot stand here" + words);
    CHECK(finding("10px") == "2+2 \"px\" cannot stand here" + words);
    CHECK(finding("0x10") == "1+3 \"x10\" cannot stand here" + words);
    CHECK(finding("1..2") == "2+1 \".\" cannot stand here" + words);
    CHECK(finding("2^3") == "1+1 \"^\" cannot stand here" + words);
    CHECK(finding("==2") == "1+1 \"=\" cannot stand here" + words);
    CHECK(finding(std::string_view{"1\0002", 3}) == "1+1 \"<U+0000>\" cannot stand here" + words);
    CHECK(finding("1\xFF") == "1+1 \"<0xFF>\" cannot stand here" + words);
}

TEST_CASE("slips are told in words of their own")
{
    CHECK(finding("1 \u2212 2") == "2+3 \"\u2212\" cannot stand here (the minus of the keyboard is -)");
    CHECK(finding("2 \u00D7 3") == "2+2 \"\u00D7\" cannot stand here (write * to multiply)");
    CHECK(finding("1,5") == "1+1 \",\" cannot stand here (a number has a point: 1.5)");
    CHECK(finding("* 2").starts_with("0+1 \"*\" cannot stand here (write a value in front of it"));
}

TEST_CASE("nothing is divided by 0, and nothing grows beyond the limit")
{
    const std::string limit = " this comes to too large a number (allowed: -1000000000 to 1000000000)";
    CHECK(finding("1/0") == "2+1 this divides by 0 (let it be something else)");
    CHECK(finding("0/(size - 20)") == "2+11 this divides by 0 (let it be something else)");
    CHECK(finding("1 + 1e9*2") == "4+5" + limit);
    CHECK(finding("1000000001") == "0+10" + limit);
    CHECK(finding("1/1e-10") == "0+7" + limit);
    CHECK(finding("1e999") == "0+5 this number is too large, or too close to 0");
    CHECK(finding("1e-999") == "0+6 this number is too large, or too close to 0");
    CHECK(value("1e9") == 1e9);
    CHECK(value("-1e9") == -1e9);
    CHECK(value("sin(1e9)") == value("sin(1000000000-360*2777777)"));
}

TEST_CASE("an expression is as long and as deep as it may be, and no more")
{
    const auto nested = [](int levels, const char* opening, const char* closing) {
        std::string text;
        for (int i = 0; i < levels; ++i)
            text += opening;
        text += '1';
        for (int i = 0; i < levels; ++i)
            text += closing;
        return text;
    };
    CHECK(value(nested(deepest_expression, "(", ")")) == 1);
    CHECK(value(nested(deepest_expression, "-", "")) == 1);
    CHECK(value(nested(deepest_expression, "round(", ")")) == 1);
    const std::string deep =
        " this expression is nested too deep (at most 32 levels; give parts of it a name: let part=…)";
    CHECK(finding(nested(deepest_expression + 1, "(", ")")) == "32+1" + deep);
    CHECK(finding(nested(400, "-", "")) == "32+1" + deep);
    CHECK(finding(nested(deepest_expression + 1, "sin(", ")")).ends_with(deep));

    std::string sum = "1";
    while (sum.size() + 2 <= longest_expression)
        sum += "+1";
    CHECK(value(sum + " ") == 500);
    CHECK(finding(sum + "+1") == "0+1001 this expression is too long (it has at most 1000 bytes; give parts "
                                 "of it a name: let part=…)");
    CHECK(finding(std::string(100'000, '(')).starts_with("0+100000 this expression is too long"));
}

TEST_CASE("the longest expression in front of something else is found with its end")
{
    Variables variables = some_variables();
    const auto front = [&variables](std::string_view text, std::size_t begin) {
        const Evaluation found = evaluate_front(text, begin, variables);
        REQUIRE(found.value);
        return std::pair{*found.value, found.end};
    };
    CHECK(front("size+1,size", 0) == std::pair{21.0, std::size_t{6}});
    CHECK(front("size+1,size", 7) == std::pair{20.0, std::size_t{11}});
    CHECK(front("steps(2*size)", 6) == std::pair{40.0, std::size_t{12}});
}

TEST_CASE("names of variables are letters, digits and _, and no functions")
{
    for (const char* name : {"a", "Size2", "_", "x_1", "rounded"})
        CHECK(is_variable_name(name));
    for (const char* name : {"", "2a", "ball-size", "gr\u00F6\u00DFe", "a b", "min", "round", "a."})
        CHECK(!is_variable_name(name));
    CHECK(names_in("2*size + max(x_2, 3e4) - size") == std::vector<std::string_view>{"size", "x_2", "size"});
    CHECK(name_in_front("size*2") == "size");
    CHECK(name_in_front("2*size") == "");
}

}
