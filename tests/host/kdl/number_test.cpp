#include "tests/host/kdl/reading.hpp"

#include "host/kdl/parser.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace kfast;
using kfast::test::errors;
using kfast::test::hint;

namespace {

kdl::Number number(const std::string& word)
{
    Diagnostics diagnostics;
    const kdl::Document document = kdl::parse("n " + word, diagnostics);
    REQUIRE_FALSE(diagnostics.has_errors());
    return *document.nodes.at(0).arguments.at(0).number();
}

constexpr double infinity = std::numeric_limits<double>::infinity();

}

TEST_CASE("decimal numbers keep their digits, without +, _ and leading zeros")
{
    CHECK(number("0").canonical == "0");
    CHECK(number("-0").canonical == "-0");
    CHECK(number("+007").canonical == "7");
    CHECK(number("1_000__0_").canonical == "10000");
    CHECK(number("0.50").canonical == "0.50");
    CHECK(number("00.5").canonical == "0.5");
    CHECK(number("-1_2.3_4_").canonical == "-12.34");
    CHECK(number("123456789012345678901234567890").canonical == "123456789012345678901234567890");
}

TEST_CASE("exponents are written with E and their sign")
{
    CHECK(number("1e3").canonical == "1E+3");
    CHECK(number("1.5E+03").canonical == "1.5E+3");
    CHECK(number("1.5e-1_0").canonical == "1.5E-10");
    CHECK(number("1e0").canonical == "1E+0");
}

TEST_CASE("hexadecimal, octal and binary numbers become decimal, whatever their size")
{
    CHECK(number("0xFf").canonical == "255");
    CHECK(number("-0o1_7_").canonical == "-15");
    CHECK(number("+0b1010").canonical == "10");
    CHECK(number("0x0").canonical == "0");
    CHECK(number("0x3B9ACA00").canonical == "1000000000");
    CHECK(number("0x10000000000000000").canonical == "18446744073709551616");
    CHECK(number("0xDE0B6B3A7640000").canonical == "1000000000000000000");
}

TEST_CASE("the value is the nearest double")
{
    CHECK(number("0.1").value == 0.1);
    CHECK(number("-12.5e-1").value == -1.25);
    CHECK(number("9007199254740993").value == 9007199254740992.0);
    CHECK(number("0x10000000000000000").value == 18446744073709551616.0);
    CHECK(std::signbit(number("-0").value));
}

TEST_CASE("numbers out of the range of double are infinite or 0")
{
    CHECK(number("1e400").value == infinity);
    CHECK(number("-1e400").value == -infinity);
    CHECK(number("1e-400").value == 0);
    CHECK(std::signbit(number("-1e-400").value));
    CHECK(number("1e99999999999999999999999").value == infinity);
    CHECK(number("1e-99999999999999999999999").value == 0);
    CHECK(number("1" + std::string(800, '0') + "e-400").value == infinity);
    CHECK(number("0." + std::string(800, '0') + "1e400").value == 0);
    CHECK(number("0." + std::string(400, '0') + "1e402").value == 10);
    CHECK(number("0e999").value == 0);
}

TEST_CASE("infinity and not-a-number are keywords")
{
    CHECK(number("#inf").value == infinity);
    CHECK(number("#-inf").value == -infinity);
    CHECK(std::isnan(number("#nan").value));
    CHECK(number("#-inf").canonical == "#-inf");
}

TEST_CASE("what begins like a number must be one")
{
    CHECK(errors("n 1a") == "1:3: \"1a\" begins like a number but is none\n");
    CHECK(hint("n 1.2.3") == "put a text that begins with a digit in quotes");
    CHECK(errors("n 1.2.3") == "1:3: \"1.2.3\" begins like a number but is none\n");
    CHECK(errors("n 1e2e3") == "1:3: \"1e2e3\" begins like a number but is none\n");
    CHECK(errors("n 1e2.5") == "1:3: \"1e2.5\" begins like a number but is none\n");
    CHECK(errors("n 0X1") == "1:3: \"0X1\" begins like a number but is none\n");
    CHECK(errors("n 1e_1") == "1:3: \"1e_1\" begins like a number but is none\n");
    CHECK(errors("n -1em") == "1:3: \"-1em\" begins like a number but is none\n");
}

TEST_CASE("a unit stands before its number, if there is one")
{
    CHECK(hint("n 10px") == "write 10 alone, or put a text that begins with a digit in quotes");
    CHECK(hint("n -4.5°") == "write -4.5 alone, or put a text that begins with a digit in quotes");
    CHECK(hint("n 50%") == "write the share, like 0.5 for 50%");
    CHECK(hint("n 500ms") == "write (ms)500: a unit stands before its number");
    CHECK(hint("n 1.5s") == "write (s)1.5: a unit stands before its number");
}

TEST_CASE("commas between numbers are pointed out")
{
    CHECK(hint("n 1,5") == "write 1.5 for a fraction, 1 5 for two numbers");
    CHECK(hint("n -10,20") == "write -10.20 for a fraction, -10 20 for two numbers");
    CHECK(hint("n 1.5,2") == "separate values by spaces alone, without commas");
    CHECK(hint("n 1,2,3") == "separate values by spaces alone, without commas");
    CHECK(errors("n 1, 2, 3") == "1:3: \"1,\" begins like a number but is none\n");
    CHECK(hint("n 1, 2, 3") == "separate values by spaces alone, without commas");
}

TEST_CASE("a point stands between digits")
{
    CHECK(errors("n .5") == "1:3: a number cannot begin with its point\n");
    CHECK(errors("n -.5") == "1:3: a number cannot begin with its point\n");
    CHECK(hint("n .5") == "write a 0 before the point");
    CHECK(errors("n 1.") == "1:3: no digit follows the point of this number\n");
    CHECK(errors("n 1.e5") == "1:3: no digit follows the point of this number\n");
    CHECK(errors("n 1._5") == "1:3: no digit follows the point of this number\n");
    CHECK(hint("n 1.") == "write a 0 after the point or leave the point out");
}

TEST_CASE("an exponent has digits")
{
    CHECK(errors("n 1e") == "1:3: no digit follows the e of this number\n");
    CHECK(errors("n 1e+") == "1:3: no digit follows the e of this number\n");
    CHECK(hint("n 1e") == "write a whole exponent, as in 1e3 or 1e-3");
}

TEST_CASE("other radices have their own digits")
{
    CHECK(errors("n 0x") == "1:3: \"0x\" is not a hexadecimal number\n");
    CHECK(errors("n 0xg") == "1:3: \"0xg\" is not a hexadecimal number\n");
    CHECK(errors("n 0x_1") == "1:3: \"0x_1\" is not a hexadecimal number\n");
    CHECK(errors("n 0x1.5") == "1:3: \"0x1.5\" is not a hexadecimal number\n");
    CHECK(errors("n 0o8") == "1:3: \"0o8\" is not an octal number\n");
    CHECK(errors("n 0b12") == "1:3: \"0b12\" is not a binary number\n");
    CHECK(hint("n 0b12") == "after 0b come the digits 0 and 1; a _ may stand after a digit");
}

TEST_CASE("hexadecimal numbers end at 1000 digits, leading zeros not counted")
{
    const std::string max(1000, 'f');
    CHECK(number("0x000" + max).canonical.size() == 1205);
    CHECK(errors("n 0x" + max + "f") == "1:3: this number has more than 1000 digits\n");
    CHECK(hint("n 0x" + max + "f") == "write it in decimal");
}
