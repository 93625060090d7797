#pragma once

#include "host/picture/picture.hpp"

#include <string>
#include <vector>

namespace kfast {

/// A picture on a contact sheet, and what stands below it in the characters of digit_picture().
struct ContactPrint {
    Picture picture;
    std::string label;
};

/// All of them, of one size, in about as many rows as columns; at least one. Throws Failure when the sheet
/// has more pixels than pictures have.
Picture contact_sheet(const std::vector<ContactPrint>& prints);

}
