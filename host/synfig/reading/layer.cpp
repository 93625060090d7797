#include "host/synfig/reading/layer.hpp"

#include "host/synfig/evaluation/value_bends.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace kfast::synfig {

namespace {

constexpr std::size_t max_moments = 20'000;

}

double Driver::seconds(double frame) const
{
    double time = begin_ + frame / frame_rate_;
    for (const Gear& gear : gears_)
        time = gear.inside(time);
    return time;
}

std::vector<double> Driver::frames(double seconds, double last) const
{
    const double end = begin_ + last / frame_rate_;
    std::vector<double> moments{seconds};
    for (std::size_t i = gears_.size(); i-- > 0;) {
        std::vector<double> around;
        for (const double moment : moments)
            for (const double time : gears_[i].around(begin_, end, moment))
                if (around.size() < max_moments)
                    around.push_back(time);
        moments = std::move(around);
    }
    std::vector<double> result;
    for (const double moment : moments) {
        // Times that are frames but for rounding are frames.
        const double frame = std::round((moment - begin_) * frame_rate_ * 65536) / 65536;
        if (frame >= 0 && frame <= last)
            result.push_back(frame);
    }
    return result;
}

Driver Driver::with(Gear gear) const
{
    Driver clock = *this;
    clock.gears_.push_back(std::move(gear));
    return clock;
}

Driver::Gear running_gear(std::function<double(double)> factor, std::function<double(double)> offset)
{
    const auto around = [factor, offset](double from, double, double inside) -> std::vector<double> {
        const double speed = factor(from);
        return speed == 0 ? std::vector<double>{} : std::vector{(inside - offset(from)) / speed};
    };
    return {[factor, offset](double time) { return factor(time) * time + offset(time); }, around};
}

Driver::Gear looping_gear(double inside, double local, double duration, double shift_before)
{
    const double length = std::abs(duration);
    const double direction = duration < 0 ? -1 : 1;
    const auto phase = [=](double time) {
        // Frames are rounded: a loop begins again on its frame, not just before.
        const double turns = std::floor((time - local) / length + 1e-9);
        return std::max(0.0, time - local - turns * length);
    };
    const auto around = [=](double from, double to, double moment) {
        std::vector<double> times;
        const double first = std::floor((from - local) / length);
        const double offset = direction * (moment - inside);
        for (double turn = first; local + turn * length <= to && times.size() < max_moments; ++turn) {
            times.push_back(local + turn * length);
            if (offset > 0 && offset < length)
                times.push_back(local + turn * length + offset);
        }
        return times;
    };
    return {[=](double time) { return inside + direction * phase(time) + (time < local ? shift_before : 0); },
            around};
}

Driver::Gear free_gear(std::function<double(double)> time)
{
    return {std::move(time), [](double, double, double) { return std::vector<double>{}; }};
}

namespace {

bool says(pugi::xml_attribute attribute, bool truth)
{
    const std::string_view text = attribute.value();
    return truth ? text == "true" || text == "1" : text == "false" || text == "0";
}

/// Names that older files have.
std::string_view current_name(std::string_view name, std::string_view type)
{
    if (name == "pos" || (name == "offset" && type != "group"))
        return "origin";
    return name == "segment_list" ? "bline" : name;
}

double encoded(double channel, double gamma)
{
    return channel <= 0 ? 0 : std::min(1.0, std::pow(channel, 1 / gamma));
}

}

Layer::Layer(pugi::xml_node element, Reading& reading, const Scope& scope)
    : element_{element},
      reading_{&reading},
      scope_{scope},
      type_{element.attribute("type").value()},
      name_{element.attribute("desc").value()}
{
    reading.budget.take_node();
    if (name_.empty())
        name_ = type_;
    drawn_ = is_drawn(element);
    if (!drawn_)
        return;
    for (const pugi::xml_node child : element.children("param")) {
        const std::string_view name = current_name(child.attribute("name").value(), type_);
        if (name == "canvas") {
            canvas_ = child.attribute("use") ? reading.file.canvas_with_id(child.attribute("use").value())
                                             : child.child("canvas");
        } else if (ValueNodePtr value = reading.values.read_inside(child)) {
            for (const std::string& kind : value->unknown)
                lose("value <" + kind + '>', instead_of_value);
            parameters_.insert_or_assign(std::string{name}, std::move(value));
        }
    }
}

bool Layer::is_drawn(pugi::xml_node element)
{
    return !says(element.attribute("active"), false) &&
           !says(element.attribute("exclude_from_rendering"), true);
}

std::string Layer::path() const { return scope_.path.empty() ? name_ : scope_.path + " / " + name_; }

const ValueNode* Layer::parameter(std::string_view name) const
{
    const auto found = parameters_.find(name);
    return found == parameters_.end() ? nullptr : found->second.get();
}

Value Layer::at(std::string_view name, double frame) const
{
    const ValueNode* node = parameter(name);
    return node ? reading_->evaluator.at(*node, scope_.clock.seconds(frame)) : Value{};
}

double Layer::number(std::string_view name, double frame, double default_value) const
{
    const double value = at(name, frame).number(default_value);
    return std::isfinite(value) ? value : default_value;
}

int Layer::whole(std::string_view name, double frame, int default_value) const
{
    constexpr double max = 1e9;
    return static_cast<int>(std::clamp(number(name, frame, default_value), -max, max));
}

bool Layer::truth(std::string_view name, double frame, bool default_value) const
{
    return at(name, frame).truth(default_value);
}

Vec2 Layer::spot(std::string_view name, double frame, Vec2 default_value) const
{
    return at(name, frame).as<Vec2>(default_value);
}

std::vector<double> Layer::bends(const std::vector<std::string_view>& names) const
{
    const double end = reading_->begin + reading_->frames / reading_->frame_rate;
    ValueBends bends{reading_->values, reading_->begin, end};
    for (const std::string_view name : names)
        if (const ValueNode* node = parameter(name))
            bends.add(*node);
    std::vector<double> frames;
    for (const double time : bends.times())
        std::ranges::copy(scope_.clock.frames(time, reading_->frames), std::back_inserter(frames));
    return frames;
}

Tracing Layer::tracing(const std::vector<std::string_view>& names, double tolerance) const
{
    return {0, reading_->frames, bends(names), tolerance, &reading_->budget};
}

art::Rgb Layer::rgb(const Colour& colour) const
{
    const auto& gamma = reading_->gamma;
    return {encoded(colour.red, gamma[0]), encoded(colour.green, gamma[1]), encoded(colour.blue, gamma[2])};
}

Colour Layer::colour(const art::Rgb& rgb) const
{
    const auto& gamma = reading_->gamma;
    return {std::pow(rgb.red, gamma[0]), std::pow(rgb.green, gamma[1]), std::pow(rgb.blue, gamma[2])};
}

void Layer::lose(const std::string& feature, const std::string& instead) const
{
    reading_->losses.add({feature, path(), {}, instead});
}

void Layer::lose_others(const std::vector<std::string_view>& known) const
{
    static constexpr std::string_view common[] = {"z_depth", "amount", "blend_method", "antialias"};
    for (const auto& [name, node] : parameters_)
        if (std::ranges::find(known, name) == known.end() &&
            std::ranges::find(common, name) == std::end(common))
            lose("parameter \"" + name + "\" of " + type_, "as if it was not there");
}

}
