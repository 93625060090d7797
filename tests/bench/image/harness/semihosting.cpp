#include "tests/bench/image/harness/semihosting.hpp"

#include <array>

namespace kfast::bench::semihosting {
namespace {

constexpr std::uint32_t write0 = 0x04;
constexpr std::uint32_t exit_extended = 0x20;
constexpr std::uint32_t application_exit = 0x20026;

std::uint32_t call(std::uint32_t operation, const void* argument)
{
    register std::uint32_t r0 asm("r0") = operation;
    register const void* r1 asm("r1") = argument;
    asm volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

}

void write(const char* text) { call(write0, text); }

void write(std::uint32_t number)
{
    std::array<char, 11> digits{};
    char* first = digits.data() + digits.size() - 1;
    do {
        *--first = static_cast<char>('0' + number % 10);
        number /= 10;
    } while (number != 0);
    write(first);
}

void exit(int code)
{
    const std::array<std::uint32_t, 2> block{application_exit, static_cast<std::uint32_t>(code)};
    call(exit_extended, block.data());
    while (true) {
    }
}

}
