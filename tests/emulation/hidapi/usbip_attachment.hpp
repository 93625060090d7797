#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace kfast::test {

using Bytes = std::vector<unsigned char>;
using Setup = std::array<unsigned char, 8>;
using Milliseconds = std::chrono::milliseconds;

/// A device that a server shares over USB/IP, attached until the end of this object. Of one thread at a time.
class UsbIpAttachment {
public:
    enum class Event { something, silence, interrupted, gone };

    /// The bus and the device on it, by which a kernel knows the one that it is given.
    static constexpr std::uint32_t device_number = 0x10002;

    /// `address` is HOST:PORT, the host by its number. Null if no device is there.
    static std::optional<UsbIpAttachment> attach(const std::string& address);

    UsbIpAttachment(UsbIpAttachment&& other) noexcept;
    UsbIpAttachment(const UsbIpAttachment&) = delete;
    UsbIpAttachment& operator=(const UsbIpAttachment&) = delete;
    ~UsbIpAttachment();

    /// A request to the device, and what it answers. Null if it is stalled or the device is gone.
    std::optional<Bytes> control(const Setup& setup);
    /// A packet to an endpoint. Whether the device took it; if not, errno is ETIMEDOUT (after five seconds,
    /// as Linux does it), EPIPE or ENODEV.
    bool send(unsigned endpoint, const Bytes& packet);
    /// From now on packets of an endpoint are asked for; they come to received().
    void listen(unsigned endpoint, std::size_t packet_bytes);
    /// Waits for something to come. Below 0: for ever.
    Event wait(Milliseconds patience);

    std::deque<Bytes>& received() { return received_; }
    /// The connection, for a kernel that takes it over.
    int socket() const { return socket_; }

private:
    struct Ending {
        int status = 0;
        Bytes data;
    };

    explicit UsbIpAttachment(int socket) : socket_{socket} {}

    bool import_device();
    std::uint32_t submit(unsigned endpoint, bool is_in, std::size_t length, const Setup& setup,
                         const Bytes& data);
    std::optional<Ending> ending_of(std::uint32_t sequence);
    void unlink(std::uint32_t sequence);
    void ask_for_packet();
    bool take_message();
    bool write(const Bytes& bytes);
    bool read(unsigned char* to, std::size_t count);

    int socket_;
    bool is_gone_ = false;
    std::uint32_t sequence_ = 0;
    unsigned listened_endpoint_ = 0;
    std::size_t packet_bytes_ = 0;
    std::uint32_t asked_ = 0;
    std::map<std::uint32_t, bool> is_in_;
    std::map<std::uint32_t, Ending> endings_;
    std::deque<Bytes> received_;
};

}
