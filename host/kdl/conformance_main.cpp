#include "host/kdl/canonical.hpp"
#include "host/kdl/parser.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>

/// Runs KDL's published test cases: DIR/input/NAME.kdl must give DIR/expected_kdl/NAME.kdl, or be refused
/// where there is no such file.
namespace {

using namespace kfast;
namespace fs = std::filesystem;

std::string bytes_of(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(file), {}};
    if (!file)
        throw std::runtime_error(path.string() + ": cannot be read");
    return bytes;
}

std::string without_trailing_newlines(std::string text)
{
    text.erase(std::min(text.find_last_not_of('\n') + 1, text.size()));
    return text;
}

std::string first_difference(const std::string& expected, const std::string& given)
{
    const auto [at, ignored] = std::ranges::mismatch(expected, given);
    const auto offset = static_cast<std::size_t>(at - expected.begin());
    return "line " + std::to_string(line_column(expected, offset).line) +
           " differs\n    expected: " + std::string(line_at(expected, offset)) +
           "\n    given:    " + std::string(line_at(given, offset));
}

/// Why the case fails; empty if it does not.
std::string fault_of(const fs::path& input, const fs::path& expected)
{
    const SourceText source{.name = input.string(), .text = bytes_of(input)};
    Diagnostics diagnostics;
    const kdl::Document document = kdl::parse(source.text, diagnostics);
    if (!fs::exists(expected))
        return diagnostics.has_errors() ? "" : "accepted, must be refused";
    if (diagnostics.has_errors())
        return "refused, must be accepted\n" + format(diagnostics.sorted().front(), source);
    const std::string wanted = without_trailing_newlines(bytes_of(expected));
    const std::string given = without_trailing_newlines(kdl::canonical(document));
    return wanted == given ? "" : first_difference(wanted, given);
}

std::set<fs::path> inputs_of(const fs::path& cases)
{
    const fs::path folder = cases / "input";
    if (!fs::is_directory(folder))
        throw std::runtime_error(folder.string() + ": there is no such directory");
    std::set<fs::path> inputs;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".kdl")
            inputs.insert(entry.path());
    return inputs;
}

int run(const fs::path& cases)
{
    std::size_t failed = 0;
    const std::set<fs::path> inputs = inputs_of(cases);
    for (const fs::path& input : inputs) {
        const std::string fault = fault_of(input, cases / "expected_kdl" / input.filename());
        if (fault.empty())
            continue;
        ++failed;
        std::cout << input.filename().string() << ": " << fault << '\n';
    }
    std::cout << inputs.size() - failed << " passed, " << failed << " failed\n";
    return failed == 0 && !inputs.empty() ? 0 : 1;
}

}

int main(int argument_count, char** arguments)
try {
    if (argument_count != 2 || std::string_view{arguments[1]}.starts_with('-')) {
        std::cerr << "usage: kdl-conformance DIR\n"
                     "Runs the cases DIR/input/*.kdl against DIR/expected_kdl/*.kdl.\n";
        return 2;
    }
    return run(arguments[1]);
} catch (const std::exception& fault) {
    std::cerr << "kdl-conformance: " << fault.what() << '\n';
    return 1;
}
