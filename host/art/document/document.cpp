#include "host/art/document/document.hpp"

namespace kfast::art {

bool operator==(const Node& left, const Node& right)
{
    return left.name == right.name && left.transform == right.transform && left.opacity == right.opacity &&
           left.shown == right.shown && left.parent_tag == right.parent_tag && left.content == right.content;
}

}
