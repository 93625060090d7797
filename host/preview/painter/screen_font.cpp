#include "host/preview/painter/screen_font.hpp"

#include "host/fonts/dejavu_faces.hpp"
#include "host/program/failure.hpp"

#include <freetype/freetype.h>
#include <map>

namespace kfast {
namespace {

constexpr FT_UInt em = 12; // pixels: letters are then as wide as Painter::letter
constexpr int baseline = 12;

LetterMask mask_of(const FT_GlyphSlotRec& glyph)
{
    const FT_Bitmap& bitmap = glyph.bitmap;
    const int width = static_cast<int>(bitmap.width);
    const int height = static_cast<int>(bitmap.rows);
    LetterMask mask{{glyph.bitmap_left, baseline - glyph.bitmap_top, width, height}, {}};
    for (int y = 0; y < height; ++y) {
        const unsigned char* row = bitmap.buffer + std::ptrdiff_t{y} * bitmap.pitch;
        mask.cover.insert(mask.cover.end(), row, row + width);
    }
    return mask;
}

}

/// Owns FreeType's objects.
class ScreenFont::Face {
public:
    Face()
    {
        const auto bytes = dejavu_sans_mono();
        if (FT_Init_FreeType(&library_) != 0)
            throw Failure("FreeType cannot be started");
        if (FT_New_Memory_Face(library_, reinterpret_cast<const FT_Byte*>(bytes.data()),
                               static_cast<FT_Long>(bytes.size()), 0, &face_) != 0 ||
            FT_Set_Pixel_Sizes(face_, 0, em) != 0) {
            FT_Done_FreeType(library_);
            throw Failure("FreeType cannot read the font of the window");
        }
    }
    ~Face() { FT_Done_FreeType(library_); } // with the face
    Face(const Face&) = delete;
    Face& operator=(const Face&) = delete;

    const LetterMask& letter(char32_t character)
    {
        const auto [place, is_new] = letters_.try_emplace(character);
        if (is_new && FT_Load_Char(face_, character, FT_LOAD_RENDER) == 0)
            place->second = mask_of(*face_->glyph);
        return place->second;
    }

private:
    FT_Library library_ = nullptr;
    FT_Face face_ = nullptr;
    std::map<char32_t, LetterMask> letters_;
};

ScreenFont::ScreenFont() : face_{std::make_unique<Face>()} {}
ScreenFont::~ScreenFont() = default;

const LetterMask& ScreenFont::letter(char32_t character) { return face_->letter(character); }

}
