#pragma once

#include "host/preview/painter/painter.hpp"
#include "host/preview/panes/theme.hpp"

#include <optional>
#include <string>
#include <vector>

namespace kfast {

/// The text of the panel at the side of the window: headings, lines below them, and values with bars.
class SidePanel {
public:
    void add_heading(std::string text);
    void add(std::string text, Colour colour = theme::text);
    /// The value is at the right. A bar is filled from 0 to 1.
    void add_value(std::string name, std::string value, bool is_chosen, std::optional<double> bar = {});

    /// What a click opens; at most one.
    void add_link(std::string text);

    /// Fills the pane. Long lines are wrapped; "…" marks lines beyond the lower end. Returns where the link
    /// is; of no size if it is not visible.
    Rect draw(Painter& painter, Rect pane) const;

private:
    struct Line {
        std::string text;
        std::string value = {};
        Colour colour = {};
        bool is_heading = false;
        bool is_link = false;
        std::optional<double> bar = {};
    };

    std::vector<Line> wrapped_lines(int columns) const;
    int draw(Painter& painter, const Line& line, Rect room) const;

    std::vector<Line> lines_;
};

}
