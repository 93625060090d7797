#pragma once

#include "host/synfig/read_synfig.hpp"

#include <string>

namespace kfast::test {

struct ReadFile {
    art::Document document;
    art::Losses losses;

    /// The node that was read last, the topmost.
    const art::Node& node() const { return document.nodes.back(); }
    const art::Shape& shape() const { return std::get<art::Shape>(node().content); }
};

/// A canvas of 200 x 100 pixels, fifty of them a unit, with 10 frames per second for 2 s; (0, 0) is its
/// middle.
inline std::string canvas(const std::string& content, const std::string& attributes = "version=\"1.2\"")
{
    return "<canvas " + attributes +
           " width=\"200\" height=\"100\" view-box=\"-2 1 2 -1\" fps=\"10\" begin-time=\"0f\" "
           "end-time=\"2s\">" +
           content + "</canvas>";
}

inline ReadFile read_text(std::string text)
{
    ReadFile result;
    result.document = synfig::read_synfig({"figure.sif", std::move(text)}, result.losses);
    return result;
}

inline ReadFile read_layers(const std::string& layers) { return read_text(canvas(layers)); }

inline std::string parameter(const std::string& name, const std::string& value)
{
    return "<param name=\"" + name + "\">" + value + "</param>";
}

inline std::string real(const std::string& value) { return "<real value=\"" + value + "\"/>"; }

inline std::string vector(const std::string& x, const std::string& y)
{
    return "<vector><x>" + x + "</x><y>" + y + "</y></vector>";
}

inline std::string layer(const std::string& type, const std::string& parameters)
{
    return "<layer type=\"" + type + "\" version=\"0.3\" desc=\"thing\">" + parameters + "</layer>";
}

}
