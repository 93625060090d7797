#pragma once

#include "host/art/budget.hpp"
#include "host/art/losses.hpp"
#include "host/svg/markup/length.hpp"
#include "host/svg/markup/svg_text.hpp"
#include "host/svg/parts/part.hpp"
#include "host/svg/style/style.hpp"

#include <cstddef>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <vector>

namespace kfast::svg {

/// A drawing: its canvas in pixels, and what is drawn on it.
struct Picture {
    double width = 0;
    double height = 0;
    std::optional<art::Rgb> background;
    Part root; ///< a group
};

/// Reads the elements of a drawing.
class PartReader {
public:
    /// The outermost element; `shown` are elements that are drawn although they say "display: none".
    PartReader(pugi::xml_node root, std::vector<pugi::xml_node> shown, art::Budget& budget,
               art::Losses& losses);

    /// Throws Failure when elements are nested too deeply, and where the budget is
    /// exceeded.
    Picture read();

private:
    /// The context of an element, from those around it.
    struct Around {
        Style style;
        Measure measure;       ///< of the nearest view box
        art::Affine to_canvas; ///< from its coordinates
        std::string layer;
        int depth = 0;
        /// For a symbol that is used: the size of the "use".
        std::optional<double> width = std::nullopt;
        std::optional<double> height = std::nullopt;
        art::Affine place = {}; ///< of the content, where its element puts it after its transform
    };
    struct ElementKind {
        std::string_view name;
        /// Reads the content. `inside` are its own style and coordinates.
        void (PartReader::*read)(pugi::xml_node, Part&, Around& inside);
    };
    static const std::vector<ElementKind> kinds;

    /// Nothing if nothing of it is drawn. Symbols are drawn only where they are `used`.
    std::optional<Part> read_element(pugi::xml_node element, const Around& around, bool used = false);
    void read_children(pugi::xml_node element, Part& part, Around& inside);
    void read_first(pugi::xml_node element, Part& part, Around& inside);
    void read_use(pugi::xml_node element, Part& part, Around& inside);
    void read_box(pugi::xml_node element, Part& part, Around& inside);
    void read_shape(pugi::xml_node element, Part& part, Around& inside);
    art::Drawing dash(pugi::xml_node element, Part& part, const Around& inside);

    bool is_for_here(pugi::xml_node element, const std::string& layer);
    bool is_inside_of_itself(pugi::xml_node element, const std::string& layer);
    /// As paint(), but with the mean colour of patterns.
    std::optional<Ink> ink(const char* property, const Part& part, const Around& inside);
    std::optional<Ink> pattern_ink(pugi::xml_node pattern, const Part& part, const Around& inside);
    double tile_area(pugi::xml_node pattern, const Part& part, const Around& inside);
    void take_style(const Style& style);
    void set_background(const Style& style);
    art::Affine set_canvas(pugi::xml_node root, const Style& style);
    art::Affine own_affine(const Style& style, const Around& around, const std::string& layer);
    bool apply_clip(const char* property, const char* instead, Part& part, const Around& inside);
    bool clip_to(const art::Drawing& area, const char* feature, Part& part, const Around& inside);
    void clip_to_box(Part& part, const Around& inside, const Box& edge);
    std::optional<art::Drawing> clip_area(pugi::xml_node clip, const Part& part, const Around& inside);
    std::optional<Part> only_shape(pugi::xml_node clip, const Style& style, const Around& inside);
    bool region_covers(pugi::xml_node mask, const Part& part, const Around& inside);

    pugi::xml_node root_;
    std::vector<pugi::xml_node> shown_;
    art::Budget& budget_;
    art::Losses* losses_;
    ElementIndex index_;
    StyleSheet sheet_;
    Picture picture_;
    std::vector<pugi::xml_node> open_; ///< that are being read, from the outermost
    std::size_t style_bytes_ = 0;
    bool reads_clip_ = false; ///< so that all shapes are filled
};

}
