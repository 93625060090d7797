#include "host/synfig/read_synfig.hpp"

#include "host/failure.hpp"

namespace kfast::synfig {

art::Document read_synfig(const SourceText& source, art::Losses&)
{
    throw Failure(source.name + ": not read yet");
}

}
