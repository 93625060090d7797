#include "tests/emulation/hidapi/usbip_attachment.hpp"

#include <algorithm>
#include <arpa/inet.h>
#include <cerrno>
#include <cstdlib>
#include <netinet/tcp.h>
#include <poll.h>
#include <string_view>
#include <sys/socket.h>
#include <unistd.h>
#include <utility>

namespace kfast::test {
namespace {

// tests/emulation/usbip/messages.mjs is the other side.
constexpr std::string_view bus_id = "1-1";
constexpr std::uint32_t import_request = 0x01118003;
constexpr std::size_t device_bytes = 312;
constexpr std::size_t message_bytes = 48;
constexpr std::size_t setup_place = 40;
constexpr std::uint32_t submit_kind = 1;
constexpr std::uint32_t unlink_kind = 2;
constexpr std::uint32_t submitted_kind = 3;

constexpr Milliseconds patience_of_linux{5000};

void place(Bytes& message, std::size_t offset, std::uint32_t word)
{
    for (unsigned i = 0; i < 4; ++i)
        message[offset + i] = static_cast<unsigned char>(word >> (24 - 8 * i));
}

std::uint32_t word_at(const unsigned char* message, std::size_t offset)
{
    std::uint32_t word = 0;
    for (unsigned i = 0; i < 4; ++i)
        word = word << 8 | message[offset + i];
    return word;
}

std::optional<sockaddr_in> parsed(const std::string& address)
{
    const auto colon = address.find(':');
    sockaddr_in result{};
    result.sin_family = AF_INET;
    if (colon == std::string::npos ||
        inet_pton(AF_INET, address.substr(0, colon).c_str(), &result.sin_addr) != 1)
        return std::nullopt;
    result.sin_port = htons(static_cast<std::uint16_t>(std::atoi(address.c_str() + colon + 1)));
    return result;
}

}

std::optional<UsbIpAttachment> UsbIpAttachment::attach(const std::string& address)
{
    const auto place = parsed(address);
    if (!place)
        return std::nullopt;
    UsbIpAttachment attachment{::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)};
    const int yes = 1;
    ::setsockopt(attachment.socket_, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
    if (::connect(attachment.socket_, reinterpret_cast<const sockaddr*>(&*place), sizeof *place) != 0 ||
        !attachment.import_device())
        return std::nullopt;
    return attachment;
}

UsbIpAttachment::UsbIpAttachment(UsbIpAttachment&& other) noexcept
    : socket_{std::exchange(other.socket_, -1)},
      is_gone_{other.is_gone_},
      sequence_{other.sequence_},
      listened_endpoint_{other.listened_endpoint_},
      packet_bytes_{other.packet_bytes_},
      asked_{other.asked_},
      is_in_{std::move(other.is_in_)},
      endings_{std::move(other.endings_)},
      received_{std::move(other.received_)}
{
}

UsbIpAttachment::~UsbIpAttachment()
{
    if (socket_ >= 0)
        ::close(socket_);
}

bool UsbIpAttachment::import_device()
{
    Bytes request(8 + 32);
    place(request, 0, import_request);
    std::ranges::copy(bus_id, request.begin() + 8);
    Bytes reply(8 + device_bytes);
    return write(request) && read(reply.data(), 8) && word_at(reply.data(), 4) == 0 &&
           read(reply.data() + 8, device_bytes);
}

std::optional<Bytes> UsbIpAttachment::control(const Setup& setup)
{
    const bool is_in = (setup[0] & 0x80) != 0;
    const std::size_t length = static_cast<std::size_t>(setup[6] | setup[7] << 8);
    const auto ending = ending_of(submit(0, is_in, length, setup, {}));
    if (!ending || ending->status != 0)
        return std::nullopt;
    return ending->data;
}

bool UsbIpAttachment::send(unsigned endpoint, const Bytes& packet)
{
    const auto sequence = submit(endpoint, false, packet.size(), {}, packet);
    const auto ending = ending_of(sequence);
    if (ending)
        errno = -ending->status;
    else if (is_gone_)
        errno = ENODEV;
    else {
        unlink(sequence);
        errno = ETIMEDOUT;
    }
    return ending && ending->status == 0;
}

void UsbIpAttachment::listen(unsigned endpoint, std::size_t packet_bytes)
{
    listened_endpoint_ = endpoint;
    packet_bytes_ = packet_bytes;
    ask_for_packet();
}

void UsbIpAttachment::ask_for_packet() { asked_ = submit(listened_endpoint_, true, packet_bytes_, {}, {}); }

std::uint32_t UsbIpAttachment::submit(unsigned endpoint, bool is_in, std::size_t length, const Setup& setup,
                                      const Bytes& data)
{
    Bytes message(message_bytes + data.size());
    const std::array words{submit_kind, ++sequence_, device_number, std::uint32_t{is_in},
                           std::uint32_t{endpoint}};
    for (std::size_t i = 0; i < words.size(); ++i)
        place(message, 4 * i, words[i]);
    place(message, 24, static_cast<std::uint32_t>(length));
    std::ranges::copy(setup, message.begin() + setup_place);
    std::ranges::copy(data, message.begin() + message_bytes);
    is_in_[sequence_] = is_in;
    is_gone_ = !write(message) || is_gone_;
    return sequence_;
}

std::optional<UsbIpAttachment::Ending> UsbIpAttachment::ending_of(std::uint32_t sequence)
{
    const auto end = std::chrono::steady_clock::now() + patience_of_linux;
    while (!endings_.contains(sequence)) {
        const auto left = std::chrono::ceil<Milliseconds>(end - std::chrono::steady_clock::now());
        if (left <= Milliseconds{0} || wait(left) == Event::gone)
            return std::nullopt;
    }
    return endings_.extract(sequence).mapped();
}

void UsbIpAttachment::unlink(std::uint32_t sequence)
{
    Bytes message(message_bytes);
    const std::array words{unlink_kind, ++sequence_, device_number, 0U, 0U, sequence};
    for (std::size_t i = 0; i < words.size(); ++i)
        place(message, 4 * i, words[i]);
    is_gone_ = !write(message) || is_gone_;
}

UsbIpAttachment::Event UsbIpAttachment::wait(Milliseconds patience)
{
    if (is_gone_)
        return Event::gone;
    pollfd waiting{socket_, POLLIN, 0};
    const int count = ::poll(&waiting, 1, static_cast<int>(patience.count()));
    if (count == 0)
        return Event::silence;
    if (count < 0 && errno == EINTR)
        return Event::interrupted;
    is_gone_ = count < 0 || !take_message();
    return is_gone_ ? Event::gone : Event::something;
}

bool UsbIpAttachment::take_message()
{
    std::array<unsigned char, message_bytes> message;
    if (!read(message.data(), message.size()))
        return false;
    if (word_at(message.data(), 0) != submitted_kind)
        return true; // about a transfer that nobody waits for any more
    const auto sequence = word_at(message.data(), 4);
    Ending ending{static_cast<int>(word_at(message.data(), 20)), {}};
    if (is_in_[sequence])
        ending.data.resize(word_at(message.data(), 24));
    is_in_.erase(sequence);
    if (!read(ending.data.data(), ending.data.size()))
        return false;
    if (sequence != asked_) {
        endings_[sequence] = std::move(ending);
        return true;
    }
    received_.push_back(std::move(ending.data));
    ask_for_packet();
    return ending.status == 0;
}

bool UsbIpAttachment::write(const Bytes& bytes)
{
    for (std::size_t at = 0; at < bytes.size();) {
        const auto count = ::send(socket_, bytes.data() + at, bytes.size() - at, MSG_NOSIGNAL);
        if (count < 0 && errno != EINTR)
            return false;
        at += count < 0 ? 0 : static_cast<std::size_t>(count);
    }
    return true;
}

bool UsbIpAttachment::read(unsigned char* to, std::size_t count)
{
    for (std::size_t at = 0; at < count;) {
        const auto arrived = ::recv(socket_, to + at, count - at, 0);
        if (arrived == 0 || (arrived < 0 && errno != EINTR))
            return false;
        at += arrived < 0 ? 0 : static_cast<std::size_t>(arrived);
    }
    return true;
}

}
