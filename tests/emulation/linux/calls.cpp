// What a program that is to believe in the devices below KFAST_STAND_IN calls instead of the C library. All
// else goes through to it.

#include "tests/emulation/linux/devices.hpp"
#include "tests/emulation/linux/real_calls.hpp"
#include "tests/emulation/linux/stand_in_root.hpp"
#include "tests/emulation/linux/wires.hpp"

#include <cerrno>
#include <cstdarg>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <map>
#include <memory>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

namespace kfast::test {
namespace {

constexpr unsigned gpio_major = 254;

auto& files()
{
    static std::map<int, std::unique_ptr<StandInFile>> all;
    return all;
}

const char* device_name(const std::string& path) { return path.c_str() + path.rfind('/') + 1; }

bool is_device(const std::string& path)
{
    return path.starts_with(stand_in_root() + "/dev/") && ::access(path.c_str(), F_OK) == 0;
}

char* real_realpath(const char* path, char* resolved)
{
    static const auto call = real<char*(const char*, char*)>("realpath");
    return call(path, resolved);
}

/// Behind all links.
std::string resolved(const std::string& path)
{
    char* const place = real_realpath(path.c_str(), nullptr);
    std::string text{place == nullptr ? "" : place};
    std::free(place);
    return text;
}

/// "error 13": opening fails so.
int open_device(const std::string& link)
{
    const std::string path = resolved(link);
    if (const long error = number_of(described(path), "error", 0)) {
        errno = static_cast<int>(error);
        return -1;
    }
    const char* const name = device_name(path);
    const int number = new_descriptor();
    stand_behind(number, std::string_view{name}.starts_with("gpiochip") ? gpio_chip(name) : spi_device(name));
    return number;
}

int real_open(const char* path, int flags, mode_t mode)
{
    static const auto call = real<int(const char*, int, ...)>("open");
    return call(path, flags, mode);
}

int open_any(const char* path, int flags, mode_t mode)
{
    const std::string here = below_root(path);
    if (!here.empty() && is_device(here))
        return open_device(here);
    return real_open(here.empty() ? path : here.c_str(), flags, mode);
}

/// `call` is stat or lstat.
int stat_device(int (*call)(const char*, struct stat*), const char* path, struct stat* about)
{
    const std::string here = below_root(path);
    const int result = call(here.empty() ? path : here.c_str(), about);
    if (result == 0 && !here.empty() && is_device(here) && !S_ISLNK(about->st_mode)) {
        about->st_mode = S_IFCHR | 0600;
        about->st_rdev = ::makedev(
            gpio_major, static_cast<unsigned>(std::atoi(device_name(here) + std::strlen("gpiochip"))));
    }
    return result;
}

timespec timespec_of(std::int64_t nanoseconds)
{
    return {.tv_sec = nanoseconds / 1'000'000'000, .tv_nsec = nanoseconds % 1'000'000'000};
}

std::int64_t nanoseconds_of(const timespec& time) { return time.tv_sec * 1'000'000'000 + time.tv_nsec; }

}

void stand_behind(int number, StandInFile* file) { files()[number].reset(file); }

int new_descriptor() { return real_open("/dev/null", O_RDWR | O_CLOEXEC, 0); }

}

using namespace kfast::test;

extern "C" {

int open(const char* path, int flags, ...)
{
    va_list more;
    va_start(more, flags);
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(more, mode_t) : 0;
    va_end(more);
    return open_any(path, flags, mode);
}

/// Folders are read through it.
int openat(int folder, const char* path, int flags, ...)
{
    static const auto call = real<int(int, const char*, int, ...)>("openat");
    va_list more;
    va_start(more, flags);
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(more, mode_t) : 0;
    va_end(more);
    const std::string here = below_root(path);
    return call(folder, here.empty() ? path : here.c_str(), flags, mode);
}

std::FILE* fopen64(const char* path, const char* mode)
{
    const std::string here = below_root(path);
    return real_fopen(here.empty() ? path : here.c_str(), mode);
}

int close(int number)
{
    static const auto call = real<int(int)>("close");
    files().erase(number);
    return call(number);
}

int ioctl(int number, unsigned long request, ...)
{
    static const auto call = real<int(int, unsigned long, ...)>("ioctl");
    va_list more;
    va_start(more, request);
    void* const argument = va_arg(more, void*);
    va_end(more);
    const auto found = files().find(number);
    if (found == files().end())
        return call(number, request, argument);
    constexpr unsigned long seen = 0xFFFF'FFFF; // by the kernel: libgpiod 2 has a signed number here
    errno = found->second->control(request & seen, argument);
    return errno == 0 ? 0 : -1;
}

int access(const char* path, int mode)
{
    static const auto call = real<int(const char*, int)>("access");
    const std::string here = below_root(path);
    return call(here.empty() ? path : here.c_str(), mode);
}

int stat(const char* path, struct stat* about)
{
    return stat_device(real<int(const char*, struct stat*)>("stat"), path, about);
}

int lstat(const char* path, struct stat* about)
{
    return stat_device(real<int(const char*, struct stat*)>("lstat"), path, about);
}

/// libgpiod asks whether a device belongs to /sys/bus/gpio, and what is behind a link.
char* realpath(const char* path, char* to)
{
    const std::string prefix = "/sys/dev/char/" + std::to_string(gpio_major) + ':';
    const std::string here = below_root(path);
    if (!stand_in_root().empty() && std::string_view{path}.starts_with(prefix))
        return to == nullptr ? ::strdup("/sys/bus/gpio") : std::strcpy(to, "/sys/bus/gpio");
    if (here.empty())
        return real_realpath(path, to);
    const std::string place = resolved(here).substr(resolved(stand_in_root()).size());
    return to == nullptr ? ::strdup(place.c_str()) : std::strcpy(to, place.c_str());
}

int clock_gettime(clockid_t clock, timespec* time)
{
    static const auto call = real<int(clockid_t, timespec*)>("clock_gettime");
    if (clock != CLOCK_MONOTONIC || stand_in_root().empty())
        return call(clock, time);
    *time = timespec_of(stand_in_time());
    return 0;
}

int clock_nanosleep(clockid_t clock, int flags, const timespec* time, timespec* rest)
{
    static const auto call = real<int(clockid_t, int, const timespec*, timespec*)>("clock_nanosleep");
    if (clock != CLOCK_MONOTONIC || stand_in_root().empty())
        return call(clock, flags, time, rest);
    const std::int64_t begin = (flags & TIMER_ABSTIME) != 0 ? 0 : stand_in_time();
    return sleep_until(begin + nanoseconds_of(*time)) ? 0 : EINTR;
}

/// The rest is told as all: a signal comes at the beginning.
int nanosleep(const timespec* time, timespec* rest)
{
    static const auto call = real<int(const timespec*, timespec*)>("nanosleep");
    if (stand_in_root().empty())
        return call(time, rest);
    if (sleep_until(stand_in_time() + nanoseconds_of(*time)))
        return 0;
    if (rest != nullptr)
        *rest = *time;
    errno = EINTR;
    return -1;
}
}
