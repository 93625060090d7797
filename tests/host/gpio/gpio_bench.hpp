#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace kfast::test {

/// A computer with GPIO chips that are not there: a test is run with tests/emulation/linux in front of it,
/// and with KFAST_STAND_IN as its folder.
class GpioBench {
public:
    GpioBench()
    {
        std::filesystem::create_directories(root_);
        for (const char* const folder : {"dev", "sys", "signal"})
            std::filesystem::remove_all(root_ / folder);
        std::filesystem::create_directories(root_ / "dev");
        happened();
    }
    ~GpioBench() { happened(); }
    GpioBench(const GpioBench&) = delete;
    GpioBench& operator=(const GpioBench&) = delete;

    /// `description`: as tests/emulation/linux/gpio_chip.cpp understands it.
    void add_chip(const std::string& name, const std::string& description)
    {
        std::filesystem::create_directories(root_ / "sys/bus/gpio/devices" / name);
        std::ofstream{root_ / "sys/bus/gpio/devices" / name / "dev"}
            << "254:" << name.substr(std::string{"gpiochip"}.size()) << '\n';
        std::ofstream{root_ / "dev" / name} << description;
    }
    void add_link(const std::string& name, const std::string& to)
    {
        std::filesystem::create_symlink(to, root_ / "dev" / name);
    }
    /// `number` comes in the sleep of that number.
    void send_signal(int number, int sleep)
    {
        std::ofstream{root_ / "signal"} << number << ' ' << sleep << '\n';
    }

    /// What has happened on the wires since the last call, without its times: "line gpiochip0 3 1".
    std::vector<std::string> happened()
    {
        std::ifstream file{root_ / "wires"};
        std::vector<std::string> lines;
        std::size_t number = 0;
        for (std::string line; std::getline(file, line); ++number)
            if (number >= seen)
                lines.push_back(line.substr(line.find(' ') + 1));
        seen = number;
        return lines;
    }

private:
    static inline std::size_t seen = 0;

    std::filesystem::path root_ = std::getenv("KFAST_STAND_IN");
};

}
