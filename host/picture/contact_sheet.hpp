#pragma once

#include "host/picture/picture.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace kfast {

/// A picture on a contact sheet, and the text below it in the characters of digit_picture().
struct ContactPrint {
    Picture picture;
    std::string label;
};

/// How pictures are arranged on a sheet.
struct ContactLayout {
    std::size_t count = 1;
    int columns = 1;
    Size cell; ///< a picture with its label

    Size sheet() const;
};

/// For `count` pictures of one size, and labels of at most `longest_label` characters: in about as many rows
/// as columns, as far as a sheet in pixels of `scale` a side has room; none if it has no room for them.
std::optional<ContactLayout> contact_layout(std::size_t count, Size picture, std::size_t longest_label,
                                            int scale = 1);

/// As many prints as the layout is for, of its size.
Picture contact_sheet(const std::vector<ContactPrint>& prints, const ContactLayout& layout);

}
