#pragma once

namespace kfast {

/// What OLED controllers that choose by the commands A4h to A7h make of all pixels.
enum class OledShow { memory, all_lit, all_dark, inverse };

}
