#include "host/gpio/gpio_lookup.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <filesystem>
#include <system_error>

namespace kfast {

namespace {

namespace fs = std::filesystem;

constexpr const char* device_folder = "/dev";
constexpr std::string_view chip_prefix = "gpiochip";

/// In the order of their numbers. Links are left out: some systems have them for old names.
std::vector<std::string> chip_paths()
{
    std::vector<std::string> paths;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator{device_folder, ignored})
        if (entry.path().filename().string().starts_with(chip_prefix) && !entry.is_symlink(ignored))
            paths.push_back(entry.path().string());
    std::ranges::sort(paths, {}, [](const std::string& path) { return std::pair{path.size(), path}; });
    return paths;
}

GpioChip opened(const std::string& path)
{
    try {
        return GpioChip{path};
    } catch (const std::system_error& error) {
        throw cannot_open_chip(path, error.code().value());
    }
}

/// The chips that can be opened. Throws Failure if there is none.
std::vector<GpioChip> all_chips()
{
    const std::vector<std::string> paths = chip_paths();
    if (paths.empty())
        throw Failure{"this computer has no GPIO chip, there is no /dev/gpiochip*", ExitStatus::no_device};
    std::vector<GpioChip> chips;
    int error = 0;
    std::string closed;
    for (const std::string& path : paths) {
        try {
            chips.emplace_back(path);
        } catch (const std::system_error& reason) {
            error = reason.code().value();
            closed = path;
        }
    }
    if (chips.empty())
        throw cannot_open_chip(closed, error);
    return chips;
}

std::string list_of(const std::vector<GpioChip>& chips)
{
    std::string list;
    for (const GpioChip& chip : chips)
        list += (list.empty() ? "" : ", ") + text_of(chip);
    return list;
}

GpioChip chip_with_label(const std::string& label)
{
    std::vector<GpioChip> chips = all_chips();
    const auto has_label = [&label](const GpioChip& chip) { return chip.label() == label; };
    const auto found = std::ranges::find_if(chips, has_label);
    if (found == chips.end())
        throw Failure{"there is no GPIO chip '" + label + "': there are " + list_of(chips),
                      ExitStatus::no_device};
    if (std::ranges::count_if(chips, has_label) > 1)
        throw Failure{"several GPIO chips are called '" + label + "': name one by its path, like /dev/" +
                          found->name(),
                      ExitStatus::wrong_usage};
    return std::move(*found);
}

std::optional<unsigned> as_offset(const std::string& line)
{
    unsigned offset = 0;
    const auto [rest, error] = std::from_chars(line.data(), line.data() + line.size(), offset);
    return error == std::errc{} && rest == line.data() + line.size() ? std::optional{offset} : std::nullopt;
}

GpioChip only_chip(const std::string& line)
{
    std::vector<GpioChip> chips = all_chips();
    if (chips.size() > 1)
        throw Failure{"on which GPIO chip is line " + line + "? Name it: there are " + list_of(chips),
                      ExitStatus::wrong_usage};
    return std::move(chips.front());
}

/// The name "" matches no line, not even one without a name.
std::optional<unsigned> named_offset(const GpioChip& chip, const std::string& line)
{
    return line.empty() ? std::nullopt : chip.offset_of(line);
}

GpioChip chip_with_line(const std::string& line)
{
    std::vector<GpioChip> chips = all_chips();
    const auto found = std::ranges::find_if(
        chips, [&line](const GpioChip& chip) { return named_offset(chip, line).has_value(); });
    if (found == chips.end())
        throw Failure{"no GPIO chip has a line '" + line + "': 'gpioinfo' lists them. There are " +
                          list_of(chips),
                      ExitStatus::no_device};
    return std::move(*found);
}

GpioChip chosen_chip(const std::string& chip, const std::string& first_line)
{
    if (chip.empty())
        return as_offset(first_line) ? only_chip(first_line) : chip_with_line(first_line);
    if (chip.find('/') != std::string::npos)
        return opened(chip);
    const bool is_name = chip.starts_with(chip_prefix) && as_offset(chip.substr(chip_prefix.size()));
    return is_name ? opened(std::string{device_folder} + '/' + chip) : chip_with_label(chip);
}

unsigned offset_in(const GpioChip& chip, const std::string& line)
{
    const auto offset = as_offset(line);
    const auto found = offset && *offset < chip.line_count() ? offset : named_offset(chip, line);
    if (!found)
        throw Failure{text_of(chip) + " has no line '" + line + "', of " + std::to_string(chip.line_count()) +
                          ": 'gpioinfo " + chip.name() + "' lists them",
                      ExitStatus::no_device};
    return *found;
}

}

FoundLines find_lines(const std::string& chip, std::span<const GpioLine> lines)
{
    FoundLines found{chosen_chip(chip, lines.front().name), {}};
    for (const GpioLine& line : lines) {
        const unsigned offset = offset_in(found.chip, line.name);
        if (std::ranges::find(found.offsets, offset) != found.offsets.end())
            throw Failure{"line '" + line.name + "' of " + text_of(found.chip) +
                              " is asked for twice: each is for one thing only",
                          ExitStatus::wrong_usage};
        found.offsets.push_back(offset);
    }
    return found;
}

namespace {

std::string reason(int error) { return std::generic_category().message(error); }

/// The lines that are in use, as far as the kernel reports it.
std::string taken_lines(const FoundLines& found)
{
    std::string text;
    for (const unsigned offset : found.offsets) {
        const std::string user = found.chip.user_of(offset);
        if (!user.empty())
            text += (text.empty() ? "line " : ", line ") + std::to_string(offset) + " by '" + user + '\'';
    }
    return text.empty() ? "one of the lines" : text;
}

}

std::string text_of(const GpioChip& chip) { return chip.name() + " (" + chip.label() + ')'; }

Failure cannot_open_chip(const std::string& path, int error)
{
    switch (error) {
    case EACCES:
    case EPERM:
        return Failure{"you may not open " + path +
                           ": where there is a group 'gpio', join it and log in again (sudo usermod -aG gpio "
                           "$USER); elsewhere a rule of udev allows it:\n  SUBSYSTEM==\"gpio\", "
                           "KERNEL==\"gpiochip*\", TAG+=\"uaccess\", GROUP=\"plugdev\", MODE=\"0660\"",
                       ExitStatus::no_permission};
    case ENOENT:
    case ENODEV:
    case ENXIO:
    case ENOTTY:
        return Failure{path + " is no GPIO chip: 'gpiodetect' lists those that there are",
                       ExitStatus::no_device};
    default:
        return Failure{path + " cannot be opened: " + reason(error), ExitStatus::refused};
    }
}

Failure cannot_have_lines(const FoundLines& found, int error, GpioDrive drive)
{
    const std::string chip = text_of(found.chip);
    if (error == EBUSY)
        return Failure{chip + ": taken: " + taken_lines(found) +
                           ": end that program, or turn the driver off; 'gpioinfo " + found.chip.name() +
                           "' tells who has what",
                       ExitStatus::refused};
    if (error == EACCES || error == EPERM)
        return cannot_open_chip("/dev/" + found.chip.name(), error);
    if (error == ENODEV)
        return Failure{chip + " is gone: was it unplugged, or its driver unbound?", ExitStatus::unplugged};
    const bool is_open = drive == GpioDrive::open_drain;
    return Failure{chip + " does not give these lines as " + (is_open ? "open-drain " : "") +
                       "outputs: " + reason(error) + ": take others",
                   ExitStatus::refused};
}

Failure cannot_set_lines(const std::string& chip, int error)
{
    return Failure{chip + " does not set its lines any more: " + reason(error) +
                       ": was it unplugged, or its driver unbound?",
                   ExitStatus::unplugged};
}

}
