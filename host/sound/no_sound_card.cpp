#include "host/program/failure.hpp"
#include "host/sound/sound_card.hpp"

namespace kfast {
namespace {

[[noreturn]] void refuse()
{
    throw Failure("this kfast was built without windows and sound: kfast export --wav makes a file to play");
}

}

std::unique_ptr<SoundCard> SoundCard::open(const std::string&, std::uint32_t, Next) { refuse(); }

std::vector<std::string> SoundCard::names() { refuse(); }

}
