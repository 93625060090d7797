// mutations FIRST COUNT FILE|FOLDER...: compiled scenes, changed and sealed, are refused or played.
#include "tests/fuzz/farewell.hpp"
#include "tests/fuzz/mutation.hpp"
#include "tests/fuzz/played.hpp"
#include "tests/fuzz/seed_files.hpp"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

using namespace kfast::test;

namespace {

std::uint32_t number_of(const char* word)
{
    return static_cast<std::uint32_t>(std::strtoul(word, nullptr, 10));
}

/// The command that plays mutation `number` alone.
std::string alone(const char* program, std::uint32_t number, std::span<const std::string> places)
{
    std::string command = std::string{program} + " " + std::to_string(number) + " 1";
    for (const std::string& place : places)
        command += " " + place;
    return command;
}

Played play_mutation(std::span<const Bytes> seeds, std::uint32_t number)
{
    Way way = way_of(number);
    way.moments = 8;
    way.beam_moments = 3;
    return play(changed_and_sealed(seeds, number), way);
}

}

int main(int count, char** words)
{
    if (count < 4) {
        std::fputs("usage: mutations FIRST COUNT FILE|FOLDER...\n", stderr);
        return 2;
    }
    const std::uint32_t first = number_of(words[1]);
    const std::uint32_t mutations = number_of(words[2]);
    const std::vector<std::string> places(words + 3, words + count);
    const std::vector<Bytes> seeds = read_scenes(places);

    Played played;
    for (std::uint32_t number = first; number != first + mutations; ++number) {
        say_if_it_ends("\nMutation " + std::to_string(number) +
                       " has failed. Alone: " + alone(words[0], number, places) + "\n");
        played += play_mutation(seeds, number);
    }
    say_if_it_ends("");
    std::printf(
        "%u mutations of %zu scenes: %llu accepted, %llu pictures (%llu coarse), %llu beam pictures\n",
        mutations, seeds.size(), static_cast<unsigned long long>(played.scenes),
        static_cast<unsigned long long>(played.pictures), static_cast<unsigned long long>(played.coarse),
        static_cast<unsigned long long>(played.beam_pictures));
    return 0;
}
