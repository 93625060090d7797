#include "host/import/content_kind.hpp"

#include "host/import/import_scene.hpp"

#include <doctest/doctest.h>

using namespace kfast::importing;
using namespace std::string_view_literals;

TEST_CASE("the first bytes tell the kind")
{
    CHECK(kind_of("{\"v\":1}") == ContentKind::json);
    CHECK(kind_of(" \r\n\t{") == ContentKind::json);
    CHECK(kind_of("\xEF\xBB\xBF{") == ContentKind::json);
    CHECK(kind_of("\xEF\xBB\xBF\n<?xml version=\"1.0\"?>") == ContentKind::xml);
    CHECK(kind_of("<svg/>") == ContentKind::xml);
    CHECK(kind_of("\x1f\x8b\x08") == ContentKind::gzip);
    CHECK(kind_of("PK\x03\x04") == ContentKind::zip);
    CHECK(kind_of("\xFF\xFE<\0"sv) == ContentKind::utf_16);
    CHECK(kind_of("\xFE\xFF\0<"sv) == ContentKind::utf_16);
    CHECK(kind_of("<\0?\0"sv) == ContentKind::utf_16);
}

TEST_CASE("what is of kfast is not imported")
{
    for (const auto text : {"kfast 1\ncanvas 9 9\n"sv, "// a comment\nkfast 1"sv, "\xEF\xBB\xBFkfast 1"sv,
                            "/* */"sv, "/- a"sv, "KFB\x02"sv, ""sv, "   "sv, "hello"sv, "\0\0"sv}) {
        CAPTURE(text);
        CHECK_FALSE(can_import(text));
    }
}

TEST_CASE("the outermost element stands behind declarations and comments")
{
    CHECK(root_element("<svg/>") == "svg");
    CHECK(root_element("<svg>") == "svg");
    CHECK(root_element("<svg width=\"1\">") == "svg");
    CHECK(root_element("<canvas\nversion='1'>") == "canvas");
    CHECK(root_element("<svg:svg xmlns:svg=\"x\">") == "svg");
    CHECK(root_element("\xEF\xBB\xBF <?xml version=\"1.0\"?>\n<!-- <canvas> --><!-- b -->\n<svg>") == "svg");
    CHECK(root_element("<!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.1//EN\" \"svg11.dtd\">\n<svg>") == "svg");
    CHECK(root_element("<!DOCTYPE svg [ <!ENTITY a \"<canvas>\"> ]>\n<svg>") == "svg");
}

TEST_CASE("what has no element has no outermost one")
{
    for (const auto text :
         {""sv, "<!--"sv, "<?xml"sv, "<!DOCTYPE svg ["sv, "<!-- a --> text"sv, "<?a?><!--"sv})
        CHECK(root_element(text) == "");
    CHECK(root_element("<") == "");
    CHECK(root_element("<svg") == "svg");
}
