#include "tests/host/scene/scene_text.hpp"
#include "tests/temporary_folder.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

namespace fs = std::filesystem;

/// A folder with Sans.ttf, the font DejaVu Sans, which has 2048 units in an em: sizes of 128 have 1/16 px a
/// unit.
class FontFolder {
public:
    FontFolder() { fs::copy_file("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", folder_ / "Sans.ttf"); }

    std::string drawn(const std::string& text) const
    {
        return drawn_in((folder_ / "").string(), "text " + text + " at=\"0,0\" size=128");
    }
    fs::path operator/(const char* name) const { return folder_ / name; }

private:
    TemporaryFolder folder_;
};

/// Replaces the folder's changing name.
std::string with_plain_folder(std::string text, const FontFolder& folder)
{
    const std::string name = (folder / "").string();
    const std::size_t at = text.find(name);
    return at == std::string::npos ? text : text.replace(at, name.size(), "FOLDER/");
}

}

TEST_CASE("letters of a font file are closed strokes")
{
    const FontFolder folder;
    // I: 201 to 403 units wide, 1493 high.
    CHECK(folder.drawn("I font=\"Sans.ttf\"") ==
          "M 12.5625 -93.3125 L 25.1875 -93.3125 L 25.1875 0 L 12.5625 0 L 12.5625 -93.3125");
}

TEST_CASE("quadratic curves become cubic ones, and composite letters are whole")
{
    const FontFolder folder;
    const std::string o = folder.drawn("o font=\"Sans.ttf\"");
    CHECK(o.find(" C ") != std::string::npos);
    CHECK(o.find(" L ") == std::string::npos);
    const std::string with_dots = folder.drawn("ö font=\"Sans.ttf\"");
    CHECK(with_dots.starts_with(o + " M "));
}

TEST_CASE("a font file's table of kerning moves letters together")
{
    const FontFolder folder;
    // The I stands 201 units from the left, the advance of A and V is 1401, and AV is kerned by -131.
    const auto left_of_i = [&](const std::string& before) {
        const std::string drawing = folder.drawn(before + "I font=\"Sans.ttf\"");
        return std::stod(drawing.substr(drawing.rfind("M ") + 2));
    };
    CHECK(left_of_i("A") == (1401 + 201) / 16.0);
    CHECK(left_of_i("AV") == (1401 - 131 + 1401 + 201) / 16.0);
}

TEST_CASE("a font may lie in a folder below the scene")
{
    const FontFolder folder;
    fs::create_directory(folder / "fonts");
    fs::rename(folder / "Sans.ttf", folder / "fonts/Sans.ttf");
    CHECK(folder.drawn("I font=\"fonts/Sans.ttf\"").starts_with("M 12.5625 -93.3125"));
    CHECK(folder.drawn("I font=\"./fonts/Sans.ttf\"").starts_with("M 12.5625 -93.3125"));
}

TEST_CASE("a character that a font file lacks is named at its place")
{
    const FontFolder folder;
    CHECK(folder.drawn("\"a日\" font=\"Sans.ttf\"") ==
          "1:8 error: the font \"Sans.ttf\" has no \"日\" (U+65E5) (no bundled font has it: name a font file "
          "beside the scene)");
}

TEST_CASE("a file that cannot be read as a font is named with its path")
{
    const FontFolder folder;
    CHECK(with_plain_folder(folder.drawn("I font=\"None.ttf\""), folder) ==
          "1:13 error: FOLDER/None.ttf: there is no such file: check the name and the folder");
    CHECK(with_plain_folder(folder.drawn("I font=\".\""), folder) ==
          "1:13 error: FOLDER/.: this is a folder: name a .ttf or .otf file in it");
    std::ofstream{folder / "text.ttf"} << "not a font";
    CHECK(with_plain_folder(folder.drawn("I font=\"text.ttf\""), folder) ==
          "1:13 error: FOLDER/text.ttf: this is no font: name a .ttf or .otf file");
    fs::resize_file(folder / "Sans.ttf", 100'000);
    CHECK(with_plain_folder(folder.drawn("I font=\"Sans.ttf\""), folder).find("FOLDER/Sans.ttf: ") !=
          std::string::npos);
}

TEST_CASE("a font's name is taken as a whole")
{
    const FontFolder folder;
    CHECK(folder.drawn("I font=\"Sans.ttf\\u{0}x\"")
              .starts_with("1:13 error: unknown font \"Sans.ttf<U+0000>x\""));
}

TEST_CASE("fonts of pixels are refused")
{
    const FontFolder folder;
    std::ofstream{folder / "pixels.bdf"}
        << "STARTFONT 2.1\nFONT x\nSIZE 8 75 75\nFONTBOUNDINGBOX 8 8 0 0\nCHARS 1\nSTARTCHAR A\nENCODING 65\n"
           "SWIDTH 500 0\nDWIDTH 8 0\nBBX 8 1 0 0\nBITMAP\nFF\nENDCHAR\nENDFONT\n";
    CHECK(with_plain_folder(folder.drawn("A font=\"pixels.bdf\""), folder) ==
          "1:13 error: FOLDER/pixels.bdf: this font has no outlines: name a .ttf or .otf file");
}

TEST_CASE("no path leads out of the scene's folder")
{
    const FontFolder folder;
    const std::string refusal = "1:13 error: a font file lies in the folder of the scene or below it "
                                "(copy it there, and write its path from there)";
    CHECK(folder.drawn("I font=\"../Sans.ttf\"") == refusal);
    CHECK(folder.drawn("I font=\"fonts/../Sans.ttf\"") == refusal);
    CHECK(folder.drawn("I font=\"" + (folder / "Sans.ttf").string() + '"') == refusal);
}

TEST_CASE("a scene that is no file has no files beside it")
{
    CHECK(drawn("text I at=\"1,2\" size=3 font=\"Sans.ttf\"") ==
          "1:29 error: this scene is no file, so there are no files beside it "
          "(allowed: dejavu-sans, dejavu-sans-bold, dejavu-sans-mono, hershey-sans, hershey-sans-medium, "
          "hershey-serif, hershey-serif-italic, hershey-script, hershey-gothic)");
}

}
