#include "tests/emulation/linux/devices.hpp"
#include "tests/emulation/linux/stand_in_root.hpp"
#include "tests/emulation/linux/wires.hpp"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <linux/gpio.h>
#include <map>
#include <memory>
#include <vector>

/// GPIO chips with both of the kernel's interfaces: version 1, which libgpiod 1.6 speaks, and version 2.
namespace kfast::test {
namespace {

using Description = std::multimap<std::string, std::string>;

/// By chip and line: who has it.
std::map<std::pair<std::string, unsigned>, std::string> takers;

struct Chip {
    std::string name;
    Description description = described(stand_in_root() + "/dev/" + name);

    unsigned line_count() const { return static_cast<unsigned>(number_of(description, "lines", 8)); }
    /// What the description says of a line under a word: "named 25 GPIO25", "taken 7 spi0 CS1".
    std::string of_line(const char* word, unsigned offset) const
    {
        for (auto [at, end] = description.equal_range(word); at != end; ++at) {
            char* rest = nullptr;
            if (std::strtoul(at->second.c_str(), &rest, 10) == offset && *rest == ' ')
                return rest + 1;
        }
        return "";
    }
    std::string taker_of(unsigned offset) const
    {
        const auto found = takers.find({name, offset});
        return found == takers.end() ? of_line("taken", offset) : found->second;
    }
    /// "vanishes-at 4": a chip at USB that is unplugged when it is asked for this line.
    bool vanishes_at(unsigned offset) const
    {
        return number_of(description, "vanishes-at", -1) == static_cast<long>(offset);
    }
};

template <std::size_t size>
void copy(const std::string& text, char (&to)[size])
{
    std::snprintf(to, size, "%s", text.c_str());
}

std::string line_text(const Chip& chip, unsigned offset) { return chip.name + ' ' + std::to_string(offset); }

/// Lines that a program has, and drives.
class Lines final : public StandInFile {
public:
    Lines(Chip chip, std::vector<unsigned> offsets, const std::string& consumer)
        : chip_{std::move(chip)}, offsets_{std::move(offsets)}
    {
        for (const unsigned offset : offsets_)
            takers[{chip_.name, offset}] = consumer;
    }
    ~Lines() override
    {
        for (const unsigned offset : offsets_) {
            takers.erase({chip_.name, offset});
            write_wires("free " + line_text(chip_, offset));
        }
    }

    int control(unsigned long request, void* argument) override
    {
        if (gone_after_ == 0)
            return ENODEV;
        if (gone_after_ > 0)
            --gone_after_;
        if (++calls_ == failing_call_)
            return EIO;
        if (request == GPIOHANDLE_SET_LINE_VALUES_IOCTL)
            set_all(static_cast<const gpiohandle_data*>(argument)->values);
        else if (request == GPIO_V2_LINE_SET_VALUES_IOCTL)
            set_some(*static_cast<const gpio_v2_line_values*>(argument));
        else
            return EINVAL;
        return 0;
    }

    void set(std::size_t index, bool level)
    {
        const auto [place, is_first] = levels_.emplace(index, level);
        if (!is_first && place->second == level)
            return;
        place->second = level;
        write_wires("line " + line_text(chip_, offsets_[index]) + (level ? " 1" : " 0"));
    }

private:
    void set_all(const __u8* values)
    {
        for (std::size_t i = 0; i < offsets_.size(); ++i)
            set(i, values[i] != 0);
    }
    void set_some(const gpio_v2_line_values& values)
    {
        for (std::size_t i = 0; i < offsets_.size(); ++i)
            if ((values.mask >> i & 1) != 0)
                set(i, (values.bits >> i & 1) != 0);
    }

    Chip chip_;
    std::vector<unsigned> offsets_;
    std::map<std::size_t, bool> levels_;
    long gone_after_ = number_of(chip_.description, "gone-after", -1);
    long failing_call_ = number_of(chip_.description, "fails-at", -1);
    long calls_ = 0;
};

class ChipFile final : public StandInFile {
public:
    explicit ChipFile(const char* name) : chip_{name} {}

    int control(unsigned long request, void* argument) override
    {
        switch (request) {
        case GPIO_GET_CHIPINFO_IOCTL:
            return fill(*static_cast<gpiochip_info*>(argument));
        case GPIO_GET_LINEINFO_IOCTL:
            return fill(*static_cast<gpioline_info*>(argument));
        case GPIO_V2_GET_LINEINFO_IOCTL:
            return fill(*static_cast<gpio_v2_line_info*>(argument));
        case GPIO_GET_LINEHANDLE_IOCTL:
            return give(*static_cast<gpiohandle_request*>(argument));
        case GPIO_V2_GET_LINE_IOCTL:
            return give(*static_cast<gpio_v2_line_request*>(argument));
        default:
            return EINVAL;
        }
    }

private:
    int fill(gpiochip_info& info) const
    {
        copy(chip_.name, info.name);
        const auto label = chip_.description.find("label");
        copy(label == chip_.description.end() ? "" : label->second, info.label);
        info.lines = chip_.line_count();
        return 0;
    }
    int fill(gpioline_info& info) const
    {
        if (info.line_offset >= chip_.line_count())
            return EINVAL;
        if (chip_.vanishes_at(info.line_offset))
            return ENODEV;
        const std::string taker = chip_.taker_of(info.line_offset);
        copy(chip_.of_line("named", info.line_offset), info.name);
        copy(taker, info.consumer);
        info.flags = taker.empty() ? 0 : GPIOLINE_FLAG_KERNEL;
        return 0;
    }
    int fill(gpio_v2_line_info& info) const
    {
        if (info.offset >= chip_.line_count())
            return EINVAL;
        const std::string taker = chip_.taker_of(info.offset);
        copy(chip_.of_line("named", info.offset), info.name);
        copy(taker, info.consumer);
        info.flags = GPIO_V2_LINE_FLAG_INPUT;
        if (!taker.empty())
            info.flags |= GPIO_V2_LINE_FLAG_USED;
        return 0;
    }

    int give(gpiohandle_request& request)
    {
        if ((request.flags & GPIOHANDLE_REQUEST_OUTPUT) == 0)
            return EINVAL;
        const bool is_open = (request.flags & GPIOHANDLE_REQUEST_OPEN_DRAIN) != 0;
        return give(
            {request.lineoffsets, request.lineoffsets + request.lines}, is_open, request.consumer_label,
            [&](std::size_t i) { return request.default_values[i] != 0; }, request.fd);
    }

    int give(gpio_v2_line_request& request)
    {
        if ((request.config.flags & GPIO_V2_LINE_FLAG_OUTPUT) == 0)
            return EINVAL;
        const bool is_open = (request.config.flags & GPIO_V2_LINE_FLAG_OPEN_DRAIN) != 0;
        const auto level = [&](std::size_t line) {
            for (unsigned i = 0; i < request.config.num_attrs; ++i) {
                const auto& [attribute, mask] = request.config.attrs[i];
                if (attribute.id == GPIO_V2_LINE_ATTR_ID_OUTPUT_VALUES && (mask >> line & 1) != 0)
                    return (attribute.values >> line & 1) != 0;
            }
            return false;
        };
        return give({request.offsets, request.offsets + request.num_lines}, is_open, request.consumer, level,
                    request.fd);
    }

    template <class Level>
    int give(std::vector<unsigned> offsets, bool is_open, const char* consumer, Level&& level, int& number)
    {
        for (std::size_t i = 0; i < offsets.size(); ++i) {
            if (offsets[i] >= chip_.line_count())
                return EINVAL;
            if (chip_.vanishes_at(offsets[i]))
                return ENODEV;
            for (std::size_t earlier = 0; earlier < i; ++earlier)
                if (offsets[earlier] == offsets[i])
                    return EBUSY;
            if (!chip_.taker_of(offsets[i]).empty())
                return EBUSY;
        }
        if (is_open && chip_.description.contains("push-pull-only"))
            return EOPNOTSUPP;
        auto lines = std::make_unique<Lines>(chip_, offsets, consumer);
        for (std::size_t i = 0; i < offsets.size(); ++i) {
            write_wires("take " + line_text(chip_, offsets[i]) + (is_open ? " open-drain" : " push-pull"));
            lines->set(i, level(i));
        }
        number = new_descriptor();
        stand_behind(number, lines.release());
        return 0;
    }

    Chip chip_;
};

}

StandInFile* gpio_chip(const char* name) { return new ChipFile{name}; }

}
