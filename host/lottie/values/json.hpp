#pragma once

#include "host/program/failure.hpp"
#include "host/text/source.hpp"

#include <nlohmann/json.hpp>
#include <string>

namespace kfast::lottie {

using Json = nlohmann::json;

/// An invalid member of the file. The text says what is wrong and what would help; read_lottie finds its
/// location by the address of the value.
class WrongMember : public Failure {
public:
    WrongMember(const Json& place, const std::string& text) : Failure{text}, place_{&place} {}

    /// Within the file as it was parsed.
    const Json* place() const { return place_; }

private:
    const Json* place_;
};

/// The farthest that a number may be from 0: what is computed from such numbers stays finite.
inline constexpr double largest_number = 1e9;

/// Nothing if there is none, if it is null, or if `owner` is no object.
const Json* find_member(const Json& owner, const char* name);

/// Each throws WrongMember where the value is of another kind; `default_value` is what a missing member is.
double number_of(const Json& value);
double number_at(const Json& owner, const char* name, double default_value);
double number_at(const Json& owner, const char* name);
/// Also accepts 0 and 1 in place of a boolean.
bool truth_at(const Json& owner, const char* name, bool default_value);
std::string text_at(const Json& owner, const char* name);
/// Empty if it is no text: what is only shown to people need not be valid.
std::string name_at(const Json& owner, const char* name);
/// A text; also a number, as if it were one.
std::string identifier_at(const Json& owner, const char* name);
const Json& array_at(const Json& owner, const char* name);

/// A whole number; others are truncated.
int whole_at(const Json& owner, const char* name, int default_value);

/// How deeply lists and objects may be nested.
inline constexpr int deepest_json = 256;

/// Throws Failure with line and column if the text is no JSON, nested too deeply, or of too many values.
Json parse_json(const SourceText& source);

/// Where `place` is within `root`, such as layers[3].ks.p; empty if it is `root`, or not in it.
std::string path_to(const Json& root, const Json* place);

}
