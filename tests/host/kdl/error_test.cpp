#include "tests/host/kdl/reading.hpp"

#include <doctest/doctest.h>

using kfast::test::errors;
using kfast::test::hint;

TEST_CASE("values are separated by spaces")
{
    CHECK(errors("n\"a\"") == "1:2: a space is missing here\n");
    CHECK(errors("n \"a\"\"b\"") == "1:6: a space is missing here\n");
    CHECK(errors("n a=1\"b\"") == "1:6: a space is missing here\n");
    CHECK(errors("n #\"a\"##") == "1:8: a space is missing here\n");
    CHECK(errors("n a#b") == "1:4: a space is missing here\n");
    CHECK(errors("n(a)") == "1:2: a space is missing here\n");
    CHECK(hint("n\"a\"") == "put a space between values, or quotes around a text with special characters");
}

TEST_CASE("characters with a meaning of their own need quotes")
{
    CHECK(errors("n [1 2]") == "1:3: \"[\" cannot stand here\n");
    CHECK(errors("n )") == "1:3: \")\" cannot stand here\n");
    CHECK(errors("n / 2") == "1:3: \"/\" cannot stand here\n");
    CHECK(errors("]") == "1:1: \"]\" cannot stand here\n");
    CHECK(hint("]") == "put a text with such characters in quotes");
}

TEST_CASE("a node begins with its name")
{
    CHECK(errors("12 a") == "1:1: a node begins with its name, not with a value\n");
    CHECK(errors("#true") == "1:1: a node begins with its name, not with a value\n");
    CHECK(hint("12 a") == "put a name before it, or in quotes");
    CHECK(errors("{ a }") == "1:1: a node name is missing here\n");
    CHECK(hint("{ a }") == "write a name here");
    CHECK(errors("(kind)\nn") == "1:7: a node name is missing here\n");
    CHECK(errors("a;;b") == "1:3: a node name is missing here\n");
    CHECK(hint("a;;b") == "remove this ;");
}

TEST_CASE("a property has a name and a value")
{
    CHECK(errors("n a=") == "1:5: a value is missing here\n");
    CHECK(errors("n a=\nm") == "1:5: a value is missing here\n");
    CHECK(errors("n a={b}") == "1:5: a value is missing here\n");
    CHECK(hint("n a=") == "write a value here");
    CHECK(errors("n = 5") == "1:3: \"=\" cannot stand here\n");
    CHECK(errors("n a==5") == "1:5: \"=\" cannot stand here\n");
    CHECK(hint("n = 5") == "a value is written as name=value or alone");
}

TEST_CASE("the name of a property is a text without a type")
{
    CHECK(errors("n 1=2") == "1:3: the name of a property must be a text\n");
    CHECK(errors("n #null=2") == "1:3: the name of a property must be a text\n");
    CHECK(hint("n 1=2") == "put it in quotes");
    CHECK(errors("n (t)a=2") == "1:3: the name of a property takes no type\n");
    CHECK(hint("n (t)a=2") == "write it as in name=(type)value");
}

TEST_CASE("a type is a text in parentheses, before something")
{
    CHECK(errors("n ()1") == "1:3: this ( ) holds no type\n");
    CHECK(errors("n ( )1") == "1:3: this ( ) holds no type\n");
    CHECK(hint("n ()1") == "name one, as in (ms)500");
    CHECK(errors("n (1)1") == "1:3: the name of a type must be a text\n");
    CHECK(errors("n (a b)1") == "1:3: this ( is not closed\n");
    CHECK(errors("n (a\nm") == "1:3: this ( is not closed\n");
    CHECK(hint("n (a\nm") == "add a ) after the name of the type");
    CHECK(errors("n (a)") == "1:6: a value is missing here\n");
    CHECK(errors("n (a)(b)1") == "1:6: \"(\" cannot stand here\n");
    CHECK(errors("n ([)1") == "1:4: \"[\" cannot stand here\n");
    CHECK(errors("n (\n") == "1:4: the name of a type is missing here\n");
}

TEST_CASE("blocks are closed, and closed once")
{
    CHECK(errors("a {\n b {\n }\n") == "1:3: this { is not closed\n");
    CHECK(hint("a {") == "add a closing }");
    CHECK(errors("a\n}\nb") == "2:1: this } closes nothing\n");
    CHECK(hint("}") == "remove it, or add the { that it belongs to");
}

TEST_CASE("a node has one block, and nothing but the end of the node after it")
{
    CHECK(errors("a { b } { c }") == "1:9: this node has a children block already\n");
    CHECK(errors("a {} /-{} {}") == "1:11: this node has a children block already\n");
    CHECK(hint("a {} {}") == "put all children in one block");
    CHECK(errors("a {} b {}") == "1:6: more follows on the line after a children block\n");
    CHECK(errors("a {b}c") == "1:6: more follows on the line after a children block\n");
    CHECK(hint("a {} b") == "begin the next node on a new line or after a ;");
}

TEST_CASE("disallowed characters are errors wherever they stand")
{
    CHECK(errors("n\x01") == "1:2: the character <U+0001> may not stand in a text\n");
    CHECK(errors("n \"\x7F\"") == "1:4: the character <U+007F> may not stand in a text\n");
    CHECK(errors("// \u202E") == "1:4: the character <U+202E> may not stand in a text\n");
    CHECK(errors("/* \u2066 */ n") == "1:4: the character <U+2066> may not stand in a text\n");
    CHECK(errors("n \uFEFF") == "1:3: the character <U+FEFF> may not stand in a text\n");
    CHECK(errors("\uFEFF\uFEFFn") == "1:2: the character <U+FEFF> may not stand in a text\n");
    CHECK(hint("n\x01") == "remove it; in a string between quotes it can be written like \\u{7F}");
}

TEST_CASE("disallowed characters side by side are one error")
{
    CHECK(errors("n\x01\x02 \x03") == "1:2: the character <U+0001> may not stand in a text\n"
                                      "1:5: the character <U+0003> may not stand in a text\n");
}

TEST_CASE("a text that is not UTF-8 is refused where it stops being so")
{
    CHECK(errors("n 1x\nm \"gr\xFC\xDF\"") == "2:6: the byte <0xFC> is not UTF-8\n");
    CHECK(errors("\xED\xA0\x80") == "1:1: the byte <0xED> is not UTF-8\n");
    CHECK(hint("\xFF") == "save the text in the encoding UTF-8");
}
