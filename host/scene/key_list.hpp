#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/drawing_reader.hpp"
#include "host/scene/model.hpp"
#include "host/scene/reading.hpp"

namespace kfast::scene {

/// Takes the nodes inside an object: keys, or the shapes of a single drawing.
class KeyList {
public:
    KeyList(Object& object, Reading& reading) : object_{object}, reading_{reading}, still_{reading} {}

    /// `node` must live until finish().
    void read(const kdl::Node& node);
    /// After the last node.
    void finish();

private:
    void add_key(const kdl::Node& node);
    void add_shape(const kdl::Node& node);
    bool in_order(const Key& key);
    bool report_order(const Key& key, const Key& before);
    void report_mixture(const kdl::Node& node);
    void report_unknown(const kdl::Node& node);

    Object& object_;
    Reading& reading_;
    DrawingReader still_;
    const kdl::Node* last_key_ = nullptr;
    bool has_shape_ = false;
    bool mixed_ = false; ///< has been reported
};

}
