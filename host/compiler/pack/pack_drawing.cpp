#include "host/compiler/pack/pack_drawing.hpp"

#include "host/compiler/pack/pack_form.hpp"

namespace kfast {

void pack_drawing(const scene::Drawing& drawing, ByteWriter& bytes)
{
    pack_drawing(drawing, bytes,
                 [](const Steps& steps, ByteWriter& form) { form.append(packed_form(steps)); });
}

}
