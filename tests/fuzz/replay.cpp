// TARGET_fuzz FIRST COUNT FILE|FOLDER...: a fuzz target without libFuzzer, which the memory sanitizer would
// have to be in, too. Runs the target with these files, and with COUNT inputs that are made of them, from
// number FIRST on.
#include "tests/fuzz/farewell.hpp"
#include "tests/fuzz/mutation.hpp"
#include "tests/fuzz/seed_files.hpp"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

using namespace kfast::test;

namespace {

std::uint32_t number_of(const char* word)
{
    return static_cast<std::uint32_t>(std::strtoul(word, nullptr, 10));
}

/// In memory of their own, so that nothing behind them is known.
void run(const Bytes& bytes, const std::string& name)
{
    say_if_it_ends("\n" + name + " has failed\n");
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

}

int main(int count, char** words)
{
    if (count < 4) {
        std::fprintf(stderr, "usage: %s FIRST COUNT FILE|FOLDER...\n", words[0]);
        return 2;
    }
    const std::uint32_t first = number_of(words[1]);
    const std::uint32_t made = number_of(words[2]);
    const std::vector<std::string> places(words + 3, words + count);
    const std::vector<Bytes> seeds = read_files(places);
    for (std::size_t number = 0; number < seeds.size(); ++number)
        run(seeds[number], "File " + std::to_string(number + 1));
    for (std::uint32_t number = first; number != first + made; ++number)
        run(changed(seeds, number), "Input " + std::to_string(number));
    std::printf("%zu files and %u inputs made of them\n", seeds.size(), made);
    return 0;
}
