#include "host/picture/scaled_source.hpp"

#include "host/picture/channel_bytes.hpp"
#include "host/picture/picture_part.hpp"

namespace kfast {

const Frame& ScaledSource::show(Time moment)
{
    const Picture picture = scaled(widen(source_->show(moment)), factor_);
    frame_ = {std::nullopt, picture.size, channel_bytes(picture)};
    return frame_;
}

}
