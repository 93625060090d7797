#include "host/preview/window/picture_window.hpp"

namespace kfast {

std::unique_ptr<PictureWindow> PictureWindow::open(const std::string&, Size) { return nullptr; }

bool PictureWindow::can_open() { return false; }

const char* PictureWindow::no_window() { return "this kfast was built without windows"; }

}
