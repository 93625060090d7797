#include "host/udev/not_allowed.hpp"

#include "host/udev/udev_rule.hpp"

namespace kfast {
namespace {

std::string_view line_with(std::string_view text, std::string_view mark)
{
    const std::size_t place = text.find(mark);
    const std::size_t begin = text.rfind('\n', place) + 1;
    return text.substr(begin, text.find('\n', place) - begin);
}

}

Failure not_allowed(const std::string& path, std::string_view mark)
{
    return Failure{"you may not open " + path + ". A rule of udev allows it:\n  " + udev_command() +
                       "\nputs it into /etc/udev/rules.d:\n  " + std::string{line_with(udev_rule, mark)} +
                       "\nThen try again; if that does not help, plug the device in anew",
                   ExitStatus::no_permission};
}

}
