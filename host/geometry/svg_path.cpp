#include "host/geometry/svg_path.hpp"

#include "host/geometry/arc.hpp"
#include "host/geometry/drawing.hpp"
#include "host/geometry/path_scanner.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace kfast::scene {
namespace {

/// The arguments of one command, with coordinates made absolute.
using Arguments = std::array<double, 7>;

class PathReader {
public:
    PathReader(std::string_view data, std::size_t points_left, Diagnostics& findings, double limit)
        : scanner_{data}, data_{data}, points_left_{points_left}, findings_{findings}, limit_{limit}
    {
    }

    std::vector<Outline> read();

private:
    /// What follows a command's letter: x and y coordinates, r a radius, a an angle, f a flag.
    struct Command {
        char letter;
        std::string_view arguments;
        void (PathReader::*draw)(const Arguments&);
    };
    static const std::array<Command, 10> commands;

    void read_command();
    void run(const Command& command, bool relative);
    bool more_arguments();
    std::optional<Arguments> read_arguments(std::string_view kinds, bool relative);
    std::optional<double> read_argument(char kind);
    std::optional<double> read_coordinate(char kind, bool relative);
    void missing_argument(char kind);

    void move(const Arguments& a);
    void line(const Arguments& a) { add(line_to({a[0], a[1]})); }
    void horizontal(const Arguments& a) { add(line_to({a[0], current_.y})); }
    void vertical(const Arguments& a) { add(line_to({current_.x, a[0]})); }
    void cubic(const Arguments& a) { add_cubic({a[0], a[1]}, {a[2], a[3]}, {a[4], a[5]}); }
    void smooth_cubic(const Arguments& a) { add_cubic(reflected("CS"), {a[0], a[1]}, {a[2], a[3]}); }
    void quadratic(const Arguments& a) { add_quadratic({a[0], a[1]}, {a[2], a[3]}); }
    void smooth_quadratic(const Arguments& a) { add_quadratic(reflected("QT"), {a[0], a[1]}); }
    void arc(const Arguments& a);
    void close(const Arguments& a);

    Vec2 reflected(std::string_view kinds) const;
    void add_cubic(Vec2 c1, Vec2 c2, Vec2 to);
    void add_quadratic(Vec2 control, Vec2 to);
    void add(const Curve& curve);
    void begin_outline();
    void end_outline();
    bool count_point();
    bool reaches(double coordinate) const { return coordinate >= -limit_ && coordinate <= limit_; }
    bool reaches(Vec2 spot) const { return reaches(spot.x) && reaches(spot.y); }
    bool reaches(const Curve& curve) const
    {
        return reaches(curve.to) && (!curve.cubic || (reaches(curve.c1) && reaches(curve.c2)));
    }
    std::string too_far() const;

    void fail(std::size_t begin, std::string message, std::string hint = {});

    PathScanner scanner_;
    std::string_view data_;
    std::size_t points_left_;
    Diagnostics& findings_;
    double limit_;
    bool failed_ = false;

    std::vector<Outline> outlines_;
    Outline outline_;
    bool drawing_ = false;   ///< outline_ is begun and not yet among outlines_
    bool lone_move_ = false; ///< has been warned about
    std::size_t begin_ = 0;  ///< where the command or its repeated arguments begin
    std::size_t move_begin_ = 0;
    char last_letter_ = '\0'; ///< of the command that was drawn before this one
    Vec2 current_;
    Vec2 start_;
    Vec2 control_; ///< the last control point of the last curve
};

const std::array<PathReader::Command, 10> PathReader::commands{{
    {'M', "xy", &PathReader::move},
    {'L', "xy", &PathReader::line},
    {'H', "x", &PathReader::horizontal},
    {'V', "y", &PathReader::vertical},
    {'C', "xyxyxy", &PathReader::cubic},
    {'S', "xyxy", &PathReader::smooth_cubic},
    {'Q', "xyxy", &PathReader::quadratic},
    {'T', "xy", &PathReader::smooth_quadratic},
    {'A', "rraffxy", &PathReader::arc},
    {'Z', "", &PathReader::close},
}};

std::vector<Outline> PathReader::read()
{
    scanner_.skip_space();
    while (!failed_ && !scanner_.at_end()) {
        read_command();
        scanner_.skip_space();
    }
    end_outline();
    return std::move(outlines_);
}

void PathReader::read_command()
{
    begin_ = scanner_.offset();
    const char letter = scanner_.take();
    const bool relative = letter >= 'a' && letter <= 'z';
    const char upper = relative ? static_cast<char>(letter - 'a' + 'A') : letter;
    const auto command = std::ranges::find(commands, upper, &Command::letter);
    if (command == commands.end())
        fail(begin_, "a path command is expected here", "allowed: M L H V C S Q T A Z and their lower case");
    else if (last_letter_ == '\0' && upper != 'M')
        fail(begin_, "a path must begin with a move", "begin with \"M x y\"");
    else
        run(*command, relative);
}

void PathReader::run(const Command& command, bool relative)
{
    const Command* repeated = &command;
    scanner_.skip_space();
    do {
        const auto arguments = read_arguments(repeated->arguments, relative);
        if (!arguments)
            return;
        (this->*repeated->draw)(*arguments);
        last_letter_ = repeated->letter;
        if (command.letter == 'M')
            repeated = &commands[1]; // the pairs after a move's first are lines
    } while (!failed_ && !command.arguments.empty() && more_arguments());
}

bool PathReader::more_arguments()
{
    const bool comma = scanner_.skip_separator();
    begin_ = scanner_.offset();
    if (comma && !scanner_.at_number())
        missing_argument('x');
    return !failed_ && scanner_.at_number();
}

std::optional<Arguments> PathReader::read_arguments(std::string_view kinds, bool relative)
{
    Arguments arguments{};
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        if (i > 0)
            scanner_.skip_separator();
        const auto argument = kinds[i] == 'x' || kinds[i] == 'y' ? read_coordinate(kinds[i], relative)
                                                                 : read_argument(kinds[i]);
        if (!argument)
            return std::nullopt;
        arguments[i] = *argument;
    }
    return arguments;
}

std::optional<double> PathReader::read_argument(char kind)
{
    std::optional<double> argument;
    if (kind != 'f')
        argument = scanner_.number();
    else if (const auto flag = scanner_.flag())
        argument = *flag ? 1 : 0;
    if (!argument)
        missing_argument(kind);
    return argument;
}

std::optional<double> PathReader::read_coordinate(char kind, bool relative)
{
    const std::size_t begin = scanner_.offset();
    auto coordinate = read_argument(kind);
    if (coordinate && relative)
        *coordinate += kind == 'x' ? current_.x : current_.y;
    if (!coordinate || reaches(*coordinate))
        return coordinate;
    fail(begin, "this point lies" + too_far());
    return std::nullopt;
}

void PathReader::missing_argument(char kind)
{
    if (kind == 'f')
        fail(scanner_.offset(), "a flag is expected here",
             "an arc is A rx ry angle large sweep x y; "
             "large and sweep are 0 or 1");
    else if (scanner_.at_number())
        fail(scanner_.offset(), "this number is out of range");
    else
        fail(scanner_.offset(), "a number is expected here",
             "M, L and T take x y; H x; V y; S and Q x y x y; C x y x y x y");
}

void PathReader::move(const Arguments& a)
{
    end_outline();
    move_begin_ = begin_;
    current_ = start_ = {a[0], a[1]};
    begin_outline();
}

void PathReader::arc(const Arguments& a)
{
    const Arc arc{.from = current_,
                  .to = {a[5], a[6]},
                  .radius_x = a[0],
                  .radius_y = a[1],
                  .rotation = a[2],
                  .large = a[3] != 0,
                  .sweep = a[4] != 0};
    for (const Curve& curve : curves_of(arc))
        add(curve);
}

void PathReader::close(const Arguments&)
{
    if (!drawing_)
        return;
    outline_.closed = true;
    current_ = start_;
    end_outline();
}

/// The first control point of a smooth curve: the last one, reflected in the current point.
Vec2 PathReader::reflected(std::string_view kinds) const
{
    return kinds.find(last_letter_) == std::string_view::npos ? current_ : 2 * current_ - control_;
}

void PathReader::add_cubic(Vec2 c1, Vec2 c2, Vec2 to)
{
    add(cubic_to(c1, c2, to));
    control_ = c2;
}

void PathReader::add_quadratic(Vec2 control, Vec2 to)
{
    add(quadratic_to(current_, control, to));
    control_ = control;
}

void PathReader::add(const Curve& curve)
{
    if (failed_)
        return;
    if (!reaches(curve))
        return fail(begin_, "this curve reaches" + too_far());
    if (!drawing_)
        begin_outline();
    if (!count_point())
        return;
    outline_.curves.push_back(curve);
    current_ = curve.to;
}

void PathReader::begin_outline()
{
    outline_ = {.from = current_, .curves = {}, .closed = false};
    drawing_ = count_point();
}

void PathReader::end_outline()
{
    if (!drawing_)
        return;
    drawing_ = false;
    if (outline_.closed || !outline_.curves.empty())
        outlines_.push_back(std::move(outline_));
    else if (!failed_ && !std::exchange(lone_move_, true))
        findings_.warning({move_begin_, 1}, "nothing is drawn from here",
                          "for a dot write \"M x y Z\", else remove the move");
}

/// Counts a point; false if there was no room for it.
bool PathReader::count_point()
{
    if (!failed_ && points_left_ == 0)
        fail(begin_, too_many_points());
    if (failed_)
        return false;
    --points_left_;
    return true;
}

std::string PathReader::too_far() const
{
    return " more than " + std::to_string(std::lround(limit_)) + " px from the origin";
}

/// Marks the text from `begin` to the scanner's position, at least one byte while there is one.
void PathReader::fail(std::size_t begin, std::string message, std::string hint)
{
    const std::size_t min = begin < data_.size() ? 1 : 0;
    const std::size_t length = std::max(scanner_.offset() - begin, min);
    findings_.error({begin, length}, std::move(message), std::move(hint));
    failed_ = true;
}

}

std::vector<Outline> read_svg_path(std::string_view data, std::size_t points_left, Diagnostics& findings,
                                   double limit)
{
    return PathReader{data, points_left, findings, limit}.read();
}

}
