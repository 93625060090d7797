#include <doctest/doctest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace {

struct Outcome {
    int status = 0;
    std::string output; ///< of both streams
};

Outcome run_tool(const std::string& arguments)
{
    const char* tool = std::getenv("KDL_CONFORMANCE");
    REQUIRE_MESSAGE(tool != nullptr, "KDL_CONFORMANCE must name the tool, as ctest does");
    std::FILE* pipe = popen(('"' + std::string(tool) + "\" " + arguments + " 2>&1").c_str(), "r");
    Outcome outcome;
    std::array<char, 256> piece{};
    while (std::fgets(piece.data(), piece.size(), pipe) != nullptr)
        outcome.output += piece.data();
    outcome.status = WEXITSTATUS(pclose(pipe));
    return outcome;
}

/// A folder of cases that lasts as long as the test.
class Cases {
public:
    Cases()
    {
        fs::create_directories(folder_ / "input");
        fs::create_directories(folder_ / "expected_kdl");
    }
    ~Cases() { fs::remove_all(folder_); }
    Cases(const Cases&) = delete;
    Cases& operator=(const Cases&) = delete;

    void write(const std::string& path, const std::string& text) const
    {
        std::ofstream(folder_ / path) << text;
    }
    Outcome run() const { return run_tool('"' + folder_.string() + '"'); }

private:
    fs::path folder_ = fs::temp_directory_path() / ("kdl-conformance-" + std::to_string(getpid()));
};

}

TEST_CASE("cases that pass are counted")
{
    const Cases cases;
    cases.write("input/good.kdl", "a   0x10; b");
    cases.write("expected_kdl/good.kdl", "a 16\nb\n");
    cases.write("input/bad_fail.kdl", "a true");
    cases.write("input/notes.txt", "no case");
    const Outcome outcome = cases.run();
    CHECK(outcome.status == 0);
    CHECK(outcome.output == "2 passed, 0 failed\n");
}

TEST_CASE("a case that is wrongly accepted fails")
{
    const Cases cases;
    cases.write("input/good.kdl", "a");
    cases.write("expected_kdl/good.kdl", "a\n");
    cases.write("input/wrong_fail.kdl", "a");
    const Outcome outcome = cases.run();
    CHECK(outcome.status == 1);
    CHECK(outcome.output == "wrong_fail.kdl: accepted, must be refused\n1 passed, 1 failed\n");
}

TEST_CASE("a case that is wrongly refused fails with its error")
{
    const Cases cases;
    cases.write("input/wrong.kdl", "a true");
    cases.write("expected_kdl/wrong.kdl", "a\n");
    const Outcome outcome = cases.run();
    CHECK(outcome.status == 1);
    CHECK(outcome.output.starts_with("wrong.kdl: refused, must be accepted\n"));
    CHECK(outcome.output.find("wrong.kdl:1:3: error: \"true\" is not a value\n") != std::string::npos);
    CHECK(outcome.output.ends_with("\n0 passed, 1 failed\n"));
}

TEST_CASE("a case that reads otherwise fails with the first line that differs")
{
    const Cases cases;
    cases.write("input/wrong.kdl", "a\nb 1\nc");
    cases.write("expected_kdl/wrong.kdl", "a\nb 2\nc\n");
    const Outcome outcome = cases.run();
    CHECK(outcome.status == 1);
    CHECK(outcome.output == "wrong.kdl: line 2 differs\n"
                            "    expected: b 2\n"
                            "    given:    b 1\n"
                            "0 passed, 1 failed\n");
}

TEST_CASE("a folder without cases is no success")
{
    const Outcome outcome = Cases{}.run();
    CHECK(outcome.status == 1);
    CHECK(outcome.output == "0 passed, 0 failed\n");
}

TEST_CASE("a missing directory is named")
{
    const Outcome outcome = run_tool("/nonexistent");
    CHECK(outcome.status == 1);
    CHECK(outcome.output == "kdl-conformance: /nonexistent/input: there is no such directory\n");
}

TEST_CASE("wrong usage is explained")
{
    for (const char* arguments : {"", "a b", "--help"}) {
        const Outcome outcome = run_tool(arguments);
        CHECK(outcome.status == 2);
        CHECK(outcome.output.starts_with("usage: kdl-conformance DIR\n"));
    }
}
