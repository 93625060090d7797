#include "host/preview/controls/help_pages.hpp"

#include "host/preview/painter/text_columns.hpp"

#include <algorithm>

namespace kfast {

namespace {

constexpr int gap = 3;         // between two columns
constexpr int min_width = 28;  // of one of several columns: narrower ones wrap too much to be read
constexpr int min_to_wrap = 8; // after the name of a key

/// A row in lines of at most `width` columns.
std::vector<HelpLine> lines_of(const std::string& row, int width)
{
    const auto key_end = std::min(row.find(' '), row.size());
    const auto text_begin = std::min(row.find_first_not_of(' ', key_end), row.size());
    const int indent = columns_of(row.substr(0, text_begin));
    if (columns_of(row) <= width || width < indent + min_to_wrap)
        return {
            {.text = cut(row, width), .key_columns = std::min(columns_of(row.substr(0, key_end)), width)}};
    std::vector<HelpLine> lines;
    for (const std::string& part : wrapped(std::string_view{row}.substr(text_begin), width - indent))
        lines.push_back({.text = std::string(static_cast<std::size_t>(indent), ' ') + part});
    lines.front().text.replace(0, static_cast<std::size_t>(indent), row, 0, text_begin);
    lines.front().key_columns = columns_of(row.substr(0, key_end));
    return lines;
}

/// Fills pages of columns of one width and height.
class HelpGrid {
public:
    HelpGrid(int columns, int width, int height) : columns_{columns}, width_{width}, height_{height} {}

    std::vector<HelpPage> pages(std::span<const std::string> rows)
    {
        pages_.assign(1, {});
        column_ = 0;
        row_ = 0;
        for (const std::string& row : rows)
            add(lines_of(row, width_));
        return std::move(pages_);
    }

private:
    void add(std::vector<HelpLine> lines)
    {
        lines.resize(std::min(lines.size(), static_cast<std::size_t>(height_)));
        if (row_ + static_cast<int>(lines.size()) > height_)
            begin_column();
        for (HelpLine& line : lines) {
            line.column = column_ * (width_ + gap);
            line.row = row_++;
            Size& cells = pages_.back().cells;
            cells.width = std::max(cells.width, line.column + columns_of(line.text));
            cells.height = std::max(cells.height, row_);
            pages_.back().lines.push_back(std::move(line));
        }
    }

    void begin_column()
    {
        row_ = 0;
        if (++column_ < columns_)
            return;
        column_ = 0;
        pages_.emplace_back();
    }

    int columns_;
    int width_;
    int height_;
    int column_ = 0;
    int row_ = 0;
    std::vector<HelpPage> pages_;
};

/// The width of each of `columns` columns beside each other.
int width_of_each(int columns, int all, int longest)
{
    return std::min((all - (columns - 1) * gap) / columns, longest);
}

/// With columns of about one height; more than one page if the rows do not fit.
std::vector<HelpPage> balanced(std::span<const std::string> rows, int columns, int width, int height)
{
    std::size_t tallest = 1;
    for (const std::string& row : rows)
        tallest = std::max(tallest, lines_of(row, width).size());
    for (int low = static_cast<int>(tallest); low < height; ++low)
        if (auto pages = HelpGrid{columns, width, low}.pages(rows); pages.size() == 1)
            return pages;
    return HelpGrid{columns, width, height}.pages(rows);
}

void add_page_numbers(std::vector<HelpPage>& pages, Size max)
{
    const std::string of = " of " + std::to_string(pages.size());
    for (std::size_t i = 0; i < pages.size(); ++i) {
        const bool is_last = i + 1 == pages.size();
        std::string text = is_last ? "h  closes this" : "h  next page";
        text = cut(text + ", " + std::to_string(i + 1) + of, max.width);
        Size& cells = pages[i].cells;
        cells = {std::max(cells.width, columns_of(text)), max.height};
        pages[i].lines.push_back({.row = max.height - 1, .text = std::move(text), .key_columns = 1});
    }
}

}

std::vector<HelpPage> help_pages(std::span<const std::string> rows, Size max)
{
    max = {std::max(max.width, 1), std::max(max.height, 1)};
    int longest = 1;
    for (const std::string& row : rows)
        longest = std::max(longest, columns_of(row));
    int columns = 1;
    for (;; ++columns) {
        auto pages = balanced(rows, columns, width_of_each(columns, max.width, longest), max.height);
        if (pages.size() == 1)
            return pages;
        if (width_of_each(columns + 1, max.width, longest) < std::min(min_width, longest))
            break;
    }
    auto pages =
        HelpGrid{columns, width_of_each(columns, max.width, longest), std::max(max.height - 1, 1)}.pages(
            rows);
    if (max.height > 1)
        add_page_numbers(pages, max);
    return pages;
}

}
