#include "host/geometry/path_scanner.hpp"

#include <charconv>
#include <system_error>

namespace kfast::scene {

bool PathScanner::at_number() const
{
    const std::size_t first = offset_ + (sign_at(offset_) ? 1 : 0);
    return digit_at(first) || (at(first) == '.' && digit_at(first + 1));
}

void PathScanner::skip_space()
{
    while (!at_end() && std::string_view{" \t\r\n\f"}.find(data_[offset_]) != std::string_view::npos)
        ++offset_;
}

bool PathScanner::skip_separator()
{
    skip_space();
    if (at(offset_) != ',')
        return false;
    ++offset_;
    skip_space();
    return true;
}

std::size_t PathScanner::digits_end(std::size_t offset) const
{
    while (digit_at(offset))
        ++offset;
    return offset;
}

/// SVG 1.1 allows a point with no digit after it, SVG 2 does not; it is allowed here.
std::size_t PathScanner::number_end() const
{
    std::size_t end = digits_end(offset_ + (sign_at(offset_) ? 1 : 0));
    if (at(end) == '.')
        end = digits_end(end + 1);
    if (at(end) != 'e' && at(end) != 'E')
        return end;
    const std::size_t exponent = end + (sign_at(end + 1) ? 2 : 1);
    return digit_at(exponent) ? digits_end(exponent) : end;
}

std::optional<double> PathScanner::number()
{
    if (!at_number())
        return std::nullopt;
    const std::size_t end = number_end();
    const std::size_t begin = offset_ + (at(offset_) == '+' ? 1 : 0); // from_chars knows no plus
    double value = 0;
    if (std::from_chars(data_.data() + begin, data_.data() + end, value).ec != std::errc{})
        return std::nullopt;
    offset_ = end;
    return value;
}

std::optional<bool> PathScanner::flag()
{
    if (at(offset_) != '0' && at(offset_) != '1')
        return std::nullopt;
    return take() == '1';
}

}
