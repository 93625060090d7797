#include "host/scene/font/outline_font.hpp"

#include "host/program/failure.hpp"

#include <freetype/freetype.h>
#include <freetype/ftoutln.h>
#include <optional>
#include <utility>

namespace kfast::scene {
namespace {

/// FreeType has y up.
Vec2 spot(const FT_Vector* vector)
{
    return {static_cast<double>(vector->x), static_cast<double>(-vector->y)};
}

Letter& letter_of(void* user) { return *static_cast<Letter*>(user); }

Vec2 pen(const Outline& outline) { return outline.curves.empty() ? outline.from : outline.curves.back().to; }

int move(const FT_Vector* to, void* user)
{
    letter_of(user).outlines.push_back({.from = spot(to), .curves = {}, .closed = true});
    return 0;
}

int line(const FT_Vector* to, void* user)
{
    letter_of(user).outlines.back().curves.push_back(line_to(spot(to)));
    return 0;
}

int quadratic(const FT_Vector* control, const FT_Vector* to, void* user)
{
    Outline& outline = letter_of(user).outlines.back();
    outline.curves.push_back(quadratic_to(pen(outline), spot(control), spot(to)));
    return 0;
}

int cubic(const FT_Vector* c1, const FT_Vector* c2, const FT_Vector* to, void* user)
{
    letter_of(user).outlines.back().curves.push_back(cubic_to(spot(c1), spot(c2), spot(to)));
    return 0;
}

constexpr FT_Outline_Funcs draw{move, line, quadratic, cubic, 0, 0};

}

/// Owns FreeType's objects and the bytes that they look into.
class OutlineFont::Face {
public:
    explicit Face(std::string bytes) : bytes_{std::move(bytes)}
    {
        if (FT_Init_FreeType(&library_) != 0)
            throw Failure("FreeType cannot be started");
        if (FT_New_Memory_Face(library_, reinterpret_cast<const FT_Byte*>(bytes_.data()),
                               static_cast<FT_Long>(bytes_.size()), 0, &face_) != 0)
            refuse("this is no font: name a .ttf or .otf file");
        if (!FT_IS_SCALABLE(face_))
            refuse("this font has no outlines: name a .ttf or .otf file");
    }
    ~Face() { FT_Done_FreeType(library_); } // with all faces
    Face(const Face&) = delete;
    Face& operator=(const Face&) = delete;

    double units_per_em() const { return face_->units_per_EM; }

    std::optional<Letter> letter(char32_t character) const
    {
        const FT_UInt glyph = FT_Get_Char_Index(face_, character);
        if (glyph == 0 || FT_Load_Glyph(face_, glyph, FT_LOAD_NO_SCALE) != 0 ||
            face_->glyph->format != FT_GLYPH_FORMAT_OUTLINE)
            return std::nullopt;
        Letter letter;
        letter.advance = static_cast<double>(face_->glyph->metrics.horiAdvance);
        if (FT_Outline_Decompose(&face_->glyph->outline, &draw, &letter) != 0)
            return std::nullopt;
        return letter;
    }

    double kerning(char32_t left, char32_t right) const
    {
        FT_Vector by{};
        if (FT_HAS_KERNING(face_))
            FT_Get_Kerning(face_, FT_Get_Char_Index(face_, left), FT_Get_Char_Index(face_, right),
                           FT_KERNING_UNSCALED, &by);
        return static_cast<double>(by.x);
    }

private:
    [[noreturn]] void refuse(const char* reason)
    {
        FT_Done_FreeType(library_);
        throw Failure(reason);
    }

    std::string bytes_;
    FT_Library library_ = nullptr;
    FT_Face face_ = nullptr;
};

OutlineFont::OutlineFont(std::string bytes) : face_{std::make_unique<Face>(std::move(bytes))} {}
OutlineFont::~OutlineFont() = default;

double OutlineFont::units_per_em() const { return face_->units_per_em(); }

const Letter* OutlineFont::letter(char32_t character)
{
    if (const auto known = letters_.find(character); known != letters_.end())
        return &known->second;
    auto letter = face_->letter(character);
    return letter ? &letters_.emplace(character, std::move(*letter)).first->second : nullptr;
}

double OutlineFont::kerning(char32_t left, char32_t right) const { return face_->kerning(left, right); }

}
